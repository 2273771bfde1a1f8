"""Claim: PPO solves the fixed scene of two blocks."""

from singulate.experiments.claims.claim import Claim, at_least
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.success import judge_success


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "ppo-fixed-2",
        "PPO solves a fixed scene of two blocks.",
        "sections 5.2 and 5.3",
        "success on 1,000 unseen episodes, pushes drawn as in training; held from a median of 90 %,"
        " partly from 50 %",
    )
    reason = (
        "the Gaussian still spreads over both blocks and the seam between them, where a push moves"
        " both at once"
    )
    return judge_success(
        claim, evidence, "ppo-fixed-2", lambda rates: at_least(rates, 0.9, 0.5), reason
    )
