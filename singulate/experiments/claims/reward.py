"""Claim: the reward of Eq. 7 learns faster than r_Dist alone."""

from singulate.experiments.claims.claim import Claim
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.faster_learning import MEASURE, learns_faster


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim("reward", "The reward of Eq. 7 is learnt from faster than r_Dist alone.",
                  "section 5.2, Fig. 3", MEASURE)  # fmt: skip
    return learns_faster(
        evidence,
        claim,
        "ppo-fixed-2-separation",
        ("Eq. 7", "r_Dist alone"),
        "r_Start pulls PPO's one Gaussian to the middle of both blocks, where pushes move both at"
        " once; r_Dist alone rewards nothing but parting them",
    )
