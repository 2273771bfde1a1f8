"""Idea: a Fourier series that parametrises the multimodality."""

from singulate.experiments.claims.claim import Claim
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.remedy import MEASURE, judge_remedy


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "fourier",
        "With a density of starts that is a Fourier series PPO solves two blocks at random places.",
        'section 6, "Fourier transformation parametrizing the multimodality"',
        MEASURE,
    )
    reason = (
        "a truncated series cannot fall off within less than half of its shortest wave, which is"
        " wide against the strip beside the seam from where one push parts two blocks"
    )
    return judge_remedy(claim, evidence, "fourier-ppo-random-2", reason)
