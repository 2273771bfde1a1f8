"""Claim: PPO fails where blocks stand at random places."""

from dataclasses import replace

from singulate.experiments.claims.claim import HELD, Claim, Numbers, at_most
from singulate.experiments.claims.evidence import Evidence, common_steps, success_rates

MIN_STEPS = 30_000


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "ppo-random-2",
        "PPO does not solve scenes of two blocks at random places.",
        "section 5.3",
        "success on 1,000 unseen scenes, pushes drawn as in training; held up to a median of 10 %,"
        " partly up to 50 %",
    )
    runs = evidence.finished("ppo-random-2", MIN_STEPS)
    if not runs:
        return replace(claim, reason=f"needs 3 seeds of at least {MIN_STEPS:,} pushes")
    rates = success_rates(runs)
    verdict = at_most(rates, 0.1, 0.5)
    return replace(
        claim,
        verdict=verdict,
        numbers=(Numbers.of("success", rates),),
        note=f"{common_steps(runs):,} pushes",
        reason=""
        if verdict == HELD
        else "the network can place the Gaussian's mean beside the blocks it sees, so that one mode"
        " of many is enough now and then",
    )
