"""Idea: a multimodal policy space, as a mixture of Gaussians."""

from singulate.experiments.claims.claim import Claim
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.remedy import MEASURE, judge_remedy


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "mixture",
        "With a mixture of Gaussians PPO solves two blocks at random places.",
        'section 6, "a multimodal policy space"',
        MEASURE,
    )
    reason = (
        "a component has its place, width and direction to learn from the few pushes that it draws"
        " itself, and a draw beyond the table or in a neighbouring direction's bin is lost"
    )
    return judge_remedy(claim, evidence, "mixture-ppo-random-2", reason)
