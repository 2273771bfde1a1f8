"""Future work: a state made smaller by an autoencoder makes learning faster."""

from dataclasses import replace
from typing import NamedTuple

from singulate.experiments.claims.claim import HELD, Claim, Numbers, both, compare
from singulate.experiments.claims.evidence import (
    Evidence,
    common_steps,
    mean_success_while_learning,
)


class Case(NamedTuple):
    """One agent on both states.

    Attributes:
        on_map: Its training on the distance map.
        on_code: Its training on the code.
        min_steps: The fewest pushes that tell.
        reason: Likely reason where the code is not learnt from faster.
    """

    on_map: str
    on_code: str
    min_steps: int
    reason: str


CASES = {
    "PPO": Case(
        "ppo-fixed-2",
        "ppo-fixed-2-code",
        20_000,
        "on fixed-2 every picture is the same, so that any state is a constant",
    ),
    "DQN": Case(
        "dqn-random-2",
        "dqn-random-2-code",
        10_000,
        "on random-2 what the code blurs, where exactly the blocks' edges are, decides what a push"
        " is worth",
    ),
}
"""By agent."""


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "autoencoder",
        "A state that an autoencoder has made smaller is learnt from faster, with a continuous and"
        " with a discrete action.",
        "section 6, future work",
        "mean success of all training pushes up to the same number, of PPO on fixed-2 and of a DQN"
        " on random-2, each on the 32 numbers of the code and on the distance map; each is held"
        " where every seed on the code beats every seed on the map, partly where the medians do;"
        " held where both are, partly where something of them is",
    )
    needed = [(name, case) for case in CASES.values() for name in (case.on_map, case.on_code)]
    missing = [name for name, case in needed if not evidence.finished(name, case.min_steps)]
    if missing:
        return replace(claim, reason=f"needs 3 seeds of {', '.join(missing)}")
    verdicts, numbers, notes = [], [], []
    for agent, case in CASES.items():
        runs = [evidence.finished(name, case.min_steps) for name in (case.on_code, case.on_map)]
        steps = common_steps(*runs)
        code, whole = (mean_success_while_learning(each, steps) for each in runs)
        verdicts.append(compare(code, whole))
        numbers += [Numbers.of(f"{agent}, code", code), Numbers.of(f"{agent}, map", whole)]
        notes.append(f"{agent}: {verdicts[-1]}, first {steps:,} pushes")
    reasons = [case.reason for case, v in zip(CASES.values(), verdicts, strict=True) if v != HELD]
    return replace(
        claim,
        verdict=both(*verdicts),
        numbers=tuple(numbers),
        note="; ".join(notes),
        reason="; ".join(reasons),
    )
