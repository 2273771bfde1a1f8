"""The icons on the page's buttons."""

import viser
from viser._icons import svg_from_icon

TRAIN = viser.Icon.PLAYER_PLAY
PAUSE_TRAINING = viser.Icon.PLAYER_PAUSE
AGENT_PUSH = viser.Icon.ROBOT


def read_icons() -> None:
    """Read them before a page needs them: for each, viser 1.1.1 goes through a list of 5,000."""
    for icon in (TRAIN, PAUSE_TRAINING, AGENT_PUSH):
        svg_from_icon(icon)
