"""Claim: TRPO shares PPO's trouble."""

from singulate.experiments.claims.claim import Claim, at_most
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.success import judge_success


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "trpo",
        "Other agents with a unimodal density, like TRPO, fail as PPO does.",
        "section 6",
        "success of TRPO on 1,000 unseen scenes of random-2, after as many pushes as PPO and drawn"
        " as in training; held up to a median of 10 %, partly up to 50 %",
    )
    reason = (
        "a step in the trust region follows the whole rollout where PPO's follow four pushes each,"
        " so that the Gaussian's mean can come to lie beside the blocks that the network sees"
    )
    return judge_success(
        claim, evidence, "trpo-random-2", lambda rates: at_most(rates, 0.1, 0.5), reason
    )
