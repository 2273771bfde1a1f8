"""Claim: PPO fails where blocks stand at random places."""

from singulate.experiments.claims.claim import Claim, at_most
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.success import judge_success


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "ppo-random-2",
        "PPO does not solve scenes of two blocks at random places.",
        "section 5.3",
        "success on 1,000 unseen scenes, pushes drawn as in training; held up to a median of 10 %,"
        " partly up to 50 %",
    )
    reason = (
        "the network can place the Gaussian's mean beside the blocks it sees, so that one mode of"
        " many is enough now and then"
    )
    return judge_success(
        claim, evidence, "ppo-random-2", lambda rates: at_most(rates, 0.1, 0.5), reason
    )
