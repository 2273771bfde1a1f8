"""The fields that can lie on the table; adding one is one line in `FIELD_KINDS`."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from app.fields.colormaps import DIVERGING, SEQUENTIAL, Colormap
from app.fields.histogram import fitting_bins, start_histogram, starts_between
from app.fields.resample import nearest_stack
from app.preferences import Preferences
from app.snapshot import Snapshot
from singulate.geometry import Workspace

Values = npt.NDArray[np.generic]
Reader = Callable[[Snapshot, Preferences, Workspace], Values | None]


@dataclass(frozen=True)
class FieldKind:
    """One entry of the list of fields.

    Attributes:
        key: Stable name.
        label: Name for people.
        read: Takes the values out of a snapshot: (4, H, W) where `is_directional`, a picture
            uint8 (H, W, 3), or a map (H, W); None where there are none yet.
        unit: Of the values, for the legend.
        is_directional: Whether there is one map for each direction.
        needs: What has to be computed for it, names of `Laboratory.set_wanted_fields`.
        colormap: How it is coloured.
        fades: Whether low values leave the table visible.
        follows_run: Whether it shows the watched training's pushes.
    """

    key: str
    label: str
    read: Reader
    unit: str = ""
    is_directional: bool = False
    needs: frozenset[str] = frozenset()
    colormap: Colormap = SEQUENTIAL
    fades: bool = False
    follows_run: bool = False


def window_of(snapshot: Snapshot, preferences: Preferences) -> tuple[int, int] | None:
    """First and last training step of the chosen window, None where no run has pushed yet."""
    run = snapshot.run
    if run is None or not len(run.start_steps):
        return None
    newest = int(run.start_steps[-1])
    last = newest if preferences.window_end is None else min(preferences.window_end, newest)
    return max(0, last - preferences.window_size + 1), last


def _nothing(snapshot: Snapshot, preferences: Preferences, workspace: Workspace) -> None:
    return None


def _distance_map(snapshot: Snapshot, _p: Preferences, _w: Workspace) -> Values | None:
    return None if snapshot.scene is None else snapshot.scene.distance_map


def _mask(snapshot: Snapshot, _p: Preferences, _w: Workspace) -> Values | None:
    return None if snapshot.scene is None else snapshot.scene.mask.astype(np.float32)


def _camera(snapshot: Snapshot, _p: Preferences, _w: Workspace) -> Values | None:
    return None if snapshot.scene is None else snapshot.scene.rgb


def _reward(snapshot: Snapshot, _p: Preferences, _w: Workspace) -> Values | None:
    return None if snapshot.reward_map is None else snapshot.reward_map.values


def _q(snapshot: Snapshot, _p: Preferences, _w: Workspace) -> Values | None:
    return None if snapshot.policy is None else snapshot.policy.q_map


def _error(snapshot: Snapshot, _p: Preferences, _w: Workspace) -> Values | None:
    truth, policy = snapshot.reward_map, snapshot.policy
    if truth is None or policy is None or policy.q_map is None:
        return None
    if truth.scene_version != policy.scene_version:
        return None
    resolution = max(truth.values.shape[1], policy.q_map.shape[1])
    return nearest_stack(policy.q_map, resolution) - nearest_stack(truth.values, resolution)


def _density(snapshot: Snapshot, _p: Preferences, _w: Workspace) -> Values | None:
    return None if snapshot.policy is None else snapshot.policy.start_density


def _histogram(snapshot: Snapshot, preferences: Preferences, workspace: Workspace) -> Values | None:
    window = window_of(snapshot, preferences)
    if window is None or snapshot.run is None:
        return None
    starts = starts_between(snapshot.run.starts, snapshot.run.start_steps, *window)
    return start_histogram(starts, workspace, fitting_bins(snapshot.run.starts, workspace))


_TRUTH = frozenset({"reward_map"})
_BELIEF = frozenset({"q_map"})

FIELD_KINDS: tuple[FieldKind, ...] = (
    FieldKind("none", "None", _nothing),
    FieldKind("distance_map", "Distance map", _distance_map, "px"),
    FieldKind("mask", "Mask", _mask),
    FieldKind("camera", "Camera image", _camera),
    FieldKind("reward", "True reward", _reward, "reward", True, _TRUTH),
    FieldKind("q", "Q of the agent", _q, "Q", True, _BELIEF),
    FieldKind("error", "Q minus reward", _error, "Q \N{MINUS SIGN} r", True,
              _TRUTH | _BELIEF, DIVERGING),
    FieldKind("start_density", "Start density", _density, "p", False,
              frozenset({"start_density"}), fades=True),
    FieldKind("start_histogram", "Start histogram", _histogram, "pushes", fades=True,
              follows_run=True),
)  # fmt: skip

_SMALL_MULTIPLES = frozenset({"reward_map", "q_map", "start_density"})

FIELDS_BY_KEY = {kind.key: kind for kind in FIELD_KINDS}
FIELDS_BY_LABEL = {kind.label: kind for kind in FIELD_KINDS}


def computed_fields(preferences: Preferences, sees_multiples: bool = True) -> frozenset[str]:
    """What has to be computed for a person's view, names of `Laboratory.set_wanted_fields`.

    Args:
        preferences: The person's choices.
        sees_multiples: Whether the tab with all directions is open.
    """
    needs = FIELDS_BY_KEY[preferences.field].needs
    is_all_shown = sees_multiples and preferences.shows_all_directions
    return needs | _SMALL_MULTIPLES if is_all_shown else needs
