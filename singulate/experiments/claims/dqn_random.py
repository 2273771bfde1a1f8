"""Claim: a DQN solves two and three blocks at random places."""

from dataclasses import replace

import numpy as np

from singulate.experiments.claims.claim import HELD, Claim, Numbers, at_least, both
from singulate.experiments.claims.evidence import (
    Evidence,
    common_steps,
    late_success,
    success_rates,
)
from singulate.experiments.figures.summaries import Summary

MIN_STEPS = 20_000
STILL_RISING = 0.02
"""Gain in success over the last fifth of a training that shows that it was too short."""
SCENARIOS = ("random-2", "random-3")


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "dqn-random",
        "Deep Q-Learning on a 10 x 10 grid solves two and three blocks at random places.",
        "section 5.4",
        "success on 1,000 unseen scenes, greedy, as a share of the scenes that some push of the"
        " 10 x 10 grid solves; each is held from a median of 90 %, partly from 50 %; held where"
        " both are, partly where something of them is",
    )
    runs = {name: evidence.finished(f"dqn-{name}", MIN_STEPS) for name in SCENARIOS}
    missing = [name for name in SCENARIOS if not runs[name] or name not in evidence.ceilings]
    if missing:
        return replace(claim, reason=f"needs 3 seeds and the ceiling of {', '.join(missing)}")
    ceilings = {name: evidence.ceilings[name]["share"] for name in SCENARIOS}
    rates = {name: success_rates(runs[name]) for name in SCENARIOS}
    shares = {name: [rate / ceilings[name] for rate in rates[name]] for name in SCENARIOS}
    verdict = both(*(at_least(shares[name], 0.9, 0.5) for name in SCENARIOS))
    limits = ", ".join(f"{name} {ceilings[name]:.1%}" for name in SCENARIOS)
    return replace(
        claim,
        verdict=verdict,
        numbers=tuple(Numbers.of(f"success on {name}", rates[name]) for name in SCENARIOS),
        note=f"ceiling of the grid: {limits}; {common_steps(*runs.values()):,} pushes",
        reason="" if verdict == HELD else _reason([r for name in SCENARIOS for r in runs[name]]),
    )


def _reason(runs: list[Summary]) -> str:
    steps = common_steps(runs)
    gains = np.subtract(late_success(runs, steps), late_success(runs, int(0.8 * steps)))
    reason = (
        "the fully connected network has to learn each place anew; the paper does not say how long"
        " it trained, nor how it explored"
    )
    if np.median(gains) > STILL_RISING:
        return f"{reason}; success still rises at the end of these trainings"
    return reason
