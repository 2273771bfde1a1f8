"""All claims, in the paper's order."""

from collections.abc import Callable

from singulate.experiments.claims import (
    action,
    autoencoder,
    dqn_random,
    dqn_values,
    fourier,
    mixture,
    ppo_fixed,
    ppo_random,
    pretraining,
    reward,
    separation,
    state,
    trpo,
    unimodality,
)
from singulate.experiments.claims.claim import Claim
from singulate.experiments.claims.evidence import Evidence

CLAIMS: tuple[Callable[[Evidence], Claim], ...] = tuple(
    module.judge
    for module in (
        state,
        action,
        reward,
        pretraining,
        ppo_fixed,
        ppo_random,
        unimodality,
        dqn_random,
        dqn_values,
        separation,
        trpo,
        autoencoder,
    )
)

IDEAS: tuple[Callable[[Evidence], Claim], ...] = tuple(
    module.judge for module in (mixture, fourier)
)
"""What the paper proposes for future work (section 6); judged with the figure ``ideas``."""

VARIANTS = (
    "ppo-fixed-2",
    "ppo-random-2",
    "dqn-fixed-2-separation",
    "dqn-random-2",
    "dqn-random-3",
    "trpo-random-2",
)
"""Trainings that claims need beyond those of the figures."""

CEILING_SCENARIOS = ("random-2", "random-3")
"""Scenarios whose ceiling on the paper's 10 x 10 grid they need."""


def judge_all(evidence: Evidence) -> list[Claim]:
    """Every claim."""
    return [judge(evidence) for judge in CLAIMS]


def judge_ideas(evidence: Evidence) -> list[Claim]:
    """Every idea."""
    return [judge(evidence) for judge in IDEAS]
