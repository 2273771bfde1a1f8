"""Claim: the distance map learns faster than the mask."""

from singulate.experiments.claims.claim import Claim
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.faster_learning import MEASURE, learns_faster


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim("state", "A distance map as state is learnt from faster than a binary mask.",
                  "section 5.2, Fig. 3", MEASURE)  # fmt: skip
    return learns_faster(
        evidence,
        claim,
        "ppo-fixed-2-mask",
        ("distance map", "binary mask"),
        "on fixed-2 every picture is the same, so that the state is a constant and carries nothing"
        " that could be learnt from; what differs is only how large a constant the network sees",
    )
