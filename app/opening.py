"""What a page opens with is there before the first browser comes."""

import threading
import time

from app.fields.catalogue import computed_fields
from app.laboratory import Laboratory
from app.panels.icons import read_icons
from app.preferences import Preferences
from app.snapshot import Snapshot
from app.views.field import print_workspace
from app.views.table import print_rim
from singulate.geometry import Workspace

LONGEST_PREPARATION_S = 10.0
_POLL_S = 0.1


def prepare_opening(laboratory: Laboratory, workspace: Workspace, stop: threading.Event) -> bool:
    """Let the laboratory put a scene on the table and compute the fields that a new page shows.

    Args:
        laboratory: Ticked until it has them, has something to complain of, or has had
            `LONGEST_PREPARATION_S`; pages can come at any time meanwhile and afterwards.
        workspace: The table.
        stop: Ends the preparation at once.

    Returns:
        Whether everything is there.
    """
    preferences = Preferences()
    wanted = computed_fields(preferences)
    laboratory.set_wanted_fields(wanted)
    print_rim(workspace, preferences.is_dark)
    print_workspace(workspace, preferences.is_dark)
    read_icons()
    give_up = time.monotonic() + LONGEST_PREPARATION_S
    while not stop.is_set() and time.monotonic() < give_up:
        snapshot = laboratory.tick()
        if snapshot.notices:
            return False
        if _is_complete(snapshot, wanted, laboratory.has_policy):
            return True
        laboratory.wait(_POLL_S)
    return False


def _is_complete(snapshot: Snapshot, wanted: frozenset[str], has_policy: bool) -> bool:
    policy, reward_map = snapshot.policy, snapshot.reward_map
    is_mapped = reward_map is not None and reward_map.progress >= 1.0
    is_believed = policy is not None and policy.scene_version > 0
    return (
        snapshot.scene is not None
        and (is_mapped or "reward_map" not in wanted)
        and (is_believed or not has_policy)
    )
