"""Claim: PPO first covers all good starts with one Gaussian whose mean lies inside the block."""

from dataclasses import replace

import numpy as np

from singulate.experiments.claims.claim import HELD, NOT_HELD, PARTLY, Claim, Numbers
from singulate.experiments.claims.evidence import Evidence

MIN_STEPS = 60_000
HALF_EXTENT_M = (0.2, 0.1)
"""Of the two blocks of fixed-2 around the origin."""


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "unimodality",
        "PPO first captures the good starts all around the blocks with a wide Gaussian whose mean"
        " lies inside the blocks.",
        "section 5.3, Fig. 6",
        "mean start of the pushes before 20,000, r_Start and r_Inside alone on fixed-2; held where"
        " it lies inside the blocks in every seed, partly where in most",
    )
    seeds = [s["moments"] for s in evidence.seeds_of("fig6")]
    if not seeds or seeds[0][-1]["step"] < MIN_STEPS:
        return replace(claim, reason="needs 3 seeds of the full Fig. 6")
    means = np.array([moments[0]["mean_m"] for moments in seeds])
    is_inside = (np.abs(means) < HALF_EXTENT_M).all(axis=1)
    share = float(is_inside.mean())
    verdict = HELD if share == 1.0 else PARTLY if share > 0.5 else NOT_HELD
    inside = [moments[0]["share_inside"] for moments in seeds]
    return replace(
        claim,
        verdict=verdict,
        numbers=(
            Numbers.of("mean start x [m]", means[:, 0].tolist()),
            Numbers.of("mean start y [m]", means[:, 1].tolist()),
            Numbers.of("starts inside a block", inside),
        ),
        note="after 20,000 pushes",
        reason="" if verdict == HELD else "by then the mean has left the blocks for one side",
    )
