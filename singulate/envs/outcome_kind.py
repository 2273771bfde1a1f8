"""What became of a push, in one word."""

from singulate.outcomes import SIMULATION_ERROR
from singulate.simulation import PushOutcome

EMPTY_PUSH_LIMIT = 0.005
"""A push that moved every block by less than this was empty [m]."""


def outcome_kind(outcome: PushOutcome, is_success: bool, has_failed: bool = False) -> str:
    """One of `OUTCOMES`; a failure of the physics first, then success.

    Args:
        outcome: What happened on the table.
        is_success: Whether the camera sees every pair of blocks apart afterwards.
        has_failed: Whether the physics went wrong.
    """
    if has_failed:
        return SIMULATION_ERROR
    if is_success:
        return "success"
    if outcome.is_blocked:
        return "inside"
    if outcome.fallen:
        return "off_table"
    return "empty" if outcome.moved < EMPTY_PUSH_LIMIT else "not_separated"
