"""Claim: a DQN's values are right after 4,000 pushes, where PPO needs 60,000."""

from dataclasses import replace

from singulate.experiments.claims.claim import (
    HELD,
    NOT_HELD,
    Claim,
    Numbers,
    at_least,
    at_most,
    both,
)
from singulate.experiments.claims.evidence import Evidence

DQN_STEPS, PPO_STEPS = 4_000, 60_000
SLOW_VALUES = "a DQN has seen each of its 400 pushes only ten times by then"
SLOW_PPO = (
    "PPO's Gaussian shrinks at another pace than the paper's: with mini-batches of 4 each gradient"
    " rests on four pushes, their advantages normalised among themselves, and the paper leaves open"
    " what else counts, such as the clipping range and the entropy bonus"
)


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "dqn-values",
        "With r_Start and r_Inside alone, a DQN's values are right after 4,000 pushes, while PPO"
        " takes 60,000 to settle on one spot.",
        "sections 5.3 and 5.4, Figs. 5 and 6",
        "DQN: correlation of its 400 values with the true rewards (held from 0.9, partly from 0.7)."
        " PPO: standard deviation of its starts along the wider axis, at most 0.15 m after 60,000"
        " pushes (partly 0.3 m), and not yet so after 20,000; held where all are",
    )
    dqn = [s for s in evidence.seeds_of("fig5") if s["num_steps"] >= DQN_STEPS]
    ppo = [s["moments"] for s in evidence.seeds_of("fig6")]
    if not dqn or not ppo or ppo[0][-1]["step"] < PPO_STEPS:
        return replace(claim, reason="needs 3 seeds of the full Figs. 5 and 6")
    correlations = [seed["correlation"] for seed in dqn]
    early, late = ([max(moments[i]["deviation_m"]) for moments in ppo] for i in (0, -1))
    settles = at_most(late, 0.15, 0.3) if min(early) > 0.15 else NOT_HELD
    values_are_right = at_least(correlations, 0.9, 0.7)
    verdict = both(values_are_right, settles)
    return replace(
        claim,
        verdict=verdict,
        numbers=(
            Numbers.of("DQN, correlation at 4,000", correlations),
            Numbers.of("DQN, reward of its best push / best", [s["share_of_best"] for s in dqn]),
            Numbers.of("PPO, deviation at 20,000 [m]", early),
            Numbers.of("PPO, deviation at 60,000 [m]", late),
        ),
        note=f"DQN right: {values_are_right}; PPO settles between 20,000 and 60,000: {settles}",
        reason="; ".join(
            reason
            for part, reason in ((values_are_right, SLOW_VALUES), (settles, SLOW_PPO))
            if part != HELD
        ),
    )
