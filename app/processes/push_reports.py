"""A finished push, told for people."""

from app.snapshot import PushReport
from singulate.envs.outcome_kind import outcome_kind
from singulate.envs.push_task import PushResult
from singulate.rewards import RewardFunction


def report_of(result: PushResult, reward: RewardFunction, by: str) -> PushReport:
    """Score a push with a reward function; what was predicted is filled in by the laboratory."""
    weighted = reward.weighted(result.terms)
    return PushReport(
        push=result.push,
        by=by,
        predicted=None,
        reward=sum(weighted.values()),
        weighted_terms=weighted,
        is_success=result.is_success,
        outcome=outcome_kind(result.outcome, result.is_success),
        num_segments=(result.before.num_segments, result.after.num_segments),
        label_images=(result.before.label_image, result.after.label_image),
    )
