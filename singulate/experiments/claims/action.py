"""Claim: point and direction learn faster than start and end."""

from singulate.experiments.claims.claim import Claim
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.faster_learning import MEASURE, learns_faster


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim("action", "A start and one of four directions are learnt faster than a start and"
                  " an end.", "section 5.2, Fig. 3", MEASURE)  # fmt: skip
    return learns_faster(
        evidence,
        claim,
        "ppo-fixed-2-start-end",
        ("point and direction", "start and end"),
        "a free end makes longer pushes possible, which meet the blocks more often, and its"
        " direction varies smoothly, where that of the point action jumps between four bins",
    )
