"""Future work: a state made smaller by an autoencoder makes learning faster."""

from dataclasses import replace

from singulate.experiments.claims.claim import HELD, Claim, Numbers, both, compare
from singulate.experiments.claims.evidence import (
    Evidence,
    common_steps,
    mean_success_while_learning,
)

CASES = {
    "PPO": ("ppo-fixed-2", "ppo-fixed-2-code", 20_000),
    "DQN": ("dqn-random-2", "dqn-random-2-code", 10_000),
}
"""By agent: its trainings on the map and on the code, and the fewest pushes that tell."""


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
    needed = [(name, steps) for *names, steps in CASES.values() for name in names]
    missing = [name for name, steps in needed if not evidence.finished(name, steps)]
    if missing:
        return replace(claim, reason=f"needs 3 seeds of {', '.join(missing)}")
    verdicts, numbers, notes = [], [], []
    for agent, (on_map, on_code, min_steps) in CASES.items():
        runs = [evidence.finished(name, min_steps) for name in (on_code, on_map)]
        steps = common_steps(*runs)
        code, whole = (mean_success_while_learning(each, steps) for each in runs)
        verdicts.append(compare(code, whole))
        numbers += [Numbers.of(f"{agent}, code", code), Numbers.of(f"{agent}, map", whole)]
        notes.append(f"{agent}: {verdicts[-1]}, first {steps:,} pushes")
    verdict = both(*verdicts)
    return replace(
        claim,
        verdict=verdict,
        numbers=tuple(numbers),
        note="; ".join(notes),
        reason=""
        if verdict == HELD
        else "on fixed-2 every picture is the same, so that any state is a constant; on random-2"
        " what the code blurs, where exactly the blocks' edges are, decides what a push is worth",
    )
