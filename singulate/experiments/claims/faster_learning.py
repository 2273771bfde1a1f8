"""Claims that one way of setting the task learns faster than another (Fig. 3)."""

from dataclasses import replace

from singulate.experiments.claims.claim import HELD, Claim, Numbers, compare
from singulate.experiments.claims.evidence import (
    Evidence,
    common_steps,
    mean_success_while_learning,
)

PROPOSED = "ppo-fixed-2"
MIN_STEPS = 20_000
"""In fewer pushes PPO has hardly begun: ten updates (Table 1)."""
MEASURE = (
    "mean success of all training pushes of PPO on fixed-2, up to the same number; held where every"
    " seed of the one beats every seed of the other, partly where the medians do"
)


def learns_faster(
    evidence: Evidence, claim: Claim, baseline: str, names: tuple[str, str], reason: str
) -> Claim:
    """Judge that the proposed task learns faster than with one part of it made simpler.

    Args:
        evidence: What was measured.
        claim: Key, statement and source.
        baseline: Variant of the simpler task.
        names: What proposed and baseline are called.
        reason: Likely reason where it does not hold.
    """
    ours = evidence.finished(PROPOSED, MIN_STEPS)
    theirs = evidence.finished(baseline, MIN_STEPS)
    if not (ours and theirs):
        return replace(claim, reason=f"needs 3 seeds of {PROPOSED} and of {baseline}")
    steps = common_steps(ours, theirs)
    rates = [mean_success_while_learning(runs, steps) for runs in (ours, theirs)]
    verdict = compare(*rates)
    return replace(
        claim,
        verdict=verdict,
        numbers=tuple(Numbers.of(*pair) for pair in zip(names, rates, strict=True)),
        note=f"first {steps:,} pushes",
        reason="" if verdict == HELD else reason,
    )
