"""What became of a push, in one word."""

from singulate.simulation import PushOutcome

EMPTY_PUSH_LIMIT = 0.005
"""A push that moved every block by less than this was empty [m]."""

OUTCOME_KINDS = ("success", "empty", "inside", "off_table", "not_separated")


def outcome_kind(outcome: PushOutcome, is_success: bool) -> str:
    """One of `OUTCOME_KINDS`, success first.

    Args:
        outcome: What happened on the table.
        is_success: Whether the camera sees every pair of blocks apart afterwards.
    """
    if is_success:
        return "success"
    if outcome.is_blocked:
        return "inside"
    if outcome.fallen:
        return "off_table"
    return "empty" if outcome.moved < EMPTY_PUSH_LIMIT else "not_separated"
