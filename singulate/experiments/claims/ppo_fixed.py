"""Claim: PPO solves the fixed scene of two blocks."""

from dataclasses import replace

from singulate.experiments.claims.claim import HELD, Claim, Numbers, at_least
from singulate.experiments.claims.evidence import Evidence, common_steps, success_rates

MIN_STEPS = 30_000


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "ppo-fixed-2",
        "PPO solves a fixed scene of two blocks.",
        "sections 5.2 and 5.3",
        "success on 1,000 unseen episodes, pushes drawn as in training; held from a median of 90 %,"
        " partly from 50 %",
    )
    runs = evidence.finished("ppo-fixed-2", MIN_STEPS)
    if not runs:
        return replace(claim, reason=f"needs 3 seeds of at least {MIN_STEPS:,} pushes")
    rates = success_rates(runs)
    verdict = at_least(rates, 0.9, 0.5)
    steps = common_steps(runs)
    return replace(
        claim,
        verdict=verdict,
        numbers=(Numbers.of("success", rates),),
        note=f"{steps:,} pushes",
        reason=""
        if verdict == HELD
        else "the Gaussian still spreads over both blocks and the seam between them, where a push"
        " moves both at once" + (f"; {steps:,} pushes are short" if steps < 60_000 else ""),
    )
