"""What claims on the success of PPO and TRPO have in common."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from singulate.experiments.claims.claim import HELD, Claim, Numbers
from singulate.experiments.claims.evidence import Evidence, common_steps, success_rates

MIN_STEPS = 30_000
FULL_STEPS = 60_000
"""As far as the paper's Fig. 6 goes."""


def judge_success(
    claim: Claim,
    evidence: Evidence,
    variant: str,
    verdict_of: Callable[[Sequence[float]], str],
    reason: str,
) -> Claim:
    """Judge a claim by the success on unseen scenes.

    Args:
        claim: Without a verdict.
        evidence: What was measured.
        variant: Whose success.
        verdict_of: Gives the verdict on one rate a seed.
        reason: Likely one, where it does not hold.
    """
    runs = evidence.finished(variant, MIN_STEPS)
    if not runs:
        return replace(claim, reason=f"needs 3 seeds of at least {MIN_STEPS:,} pushes")
    rates, steps = success_rates(runs), common_steps(runs)
    verdict = verdict_of(rates)
    shortness = f"; {steps:,} pushes are short" if steps < FULL_STEPS else ""
    return replace(
        claim,
        verdict=verdict,
        numbers=(Numbers.of("success", rates),),
        note=f"{steps:,} pushes",
        reason="" if verdict == HELD else reason + shortness,
    )
