"""Ideas of the paper's conclusion that are to make PPO solve random scenes."""

from dataclasses import replace

from singulate.experiments.claims.claim import HELD, Claim, Numbers, at_least
from singulate.experiments.claims.evidence import (
    Evidence,
    common_steps,
    mean_success_while_learning,
    success_rates,
)

MIN_STEPS = 20_000
BASELINES = {
    "success of the paper's PPO": "ppo-random-2-short",
    "success of one Gaussian with the same network": "mixture-ppo-1-random-2",
}
"""What every remedy is compared with, so that the network's share in it shows."""
MEASURE = (
    "success on 1,000 unseen scenes of random-2 after 20,000 pushes, greedy where the agent acts"
    " greedily; held from a median of 90 %, partly from 50 %"
)


def judge_remedy(claim: Claim, evidence: Evidence, variant: str, reason: str) -> Claim:
    """Judge that PPO with something changed solves two blocks at random places.

    Args:
        claim: Without a verdict.
        evidence: What was measured.
        variant: The training with the change.
        reason: Likely reason where it does not hold.
    """
    needed = (variant, *BASELINES.values())
    missing = [name for name in needed if not evidence.finished(name, MIN_STEPS)]
    if missing:
        several = f"needs 3 seeds of at least {MIN_STEPS:,} pushes of {', '.join(missing)}"
        return replace(claim, reason=several)
    runs = evidence.finished(variant, MIN_STEPS)
    steps = common_steps(runs)
    verdict = at_least(success_rates(runs), 0.9, 0.5)
    return replace(
        claim,
        verdict=verdict,
        numbers=(
            Numbers.of("success", success_rates(runs)),
            Numbers.of("mean success while learning", mean_success_while_learning(runs, steps)),
            *(
                Numbers.of(name, success_rates(evidence.finished(baseline, MIN_STEPS)))
                for name, baseline in BASELINES.items()
            ),
        ),
        note=f"{steps:,} pushes",
        reason="" if verdict == HELD else reason,
    )
