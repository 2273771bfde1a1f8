"""Claim: TRPO shares PPO's trouble."""

from singulate.experiments.claims.claim import Claim
from singulate.experiments.claims.evidence import Evidence


def judge(evidence: Evidence) -> Claim:
    """See the module: there is no such agent here yet, so it is never measured."""
    return Claim(
        "trpo",
        "Other agents with a unimodal density, like TRPO, fail as PPO does.",
        "section 6",
        "success on unseen scenes of random-2, as for PPO",
        reason="there is no TRPO among the agents yet (it would come with sb3-contrib)",
    )
