"""From a snapshot and one person's choices to the picture on their table."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from app.fields.catalogue import FIELDS_BY_KEY, FieldKind, Values
from app.fields.draped import DrapedField
from app.fields.field_image import Span, field_image, picture_image, value_span
from app.fields.legend import legend_html
from app.fields.resample import nearest
from app.preferences import CHOICES, Preferences
from app.snapshot import Snapshot
from singulate.geometry import Direction, Workspace

CRISP_SIZE = 320
"""Pixels of a draped picture: a multiple of the 10, 16, 32 and 64 cells that fields have."""


def select_direction(
    stack: Values, choice: str, aimed: Direction, is_diverging: bool = False
) -> npt.NDArray[np.float32]:
    """One map of four.

    Args:
        stack: (4, H, W).
        choice: One of `CHOICES`; ``best`` takes the largest value of every cell.
        aimed: The direction that ``as aimed`` stands for.
        is_diverging: Let ``best`` take the value farthest from zero instead.

    Returns:
        float32 (H, W).
    """
    if choice == "best":
        values = np.asarray(stack, dtype=np.float32)
        rank = np.abs(values) if is_diverging else values
        winner = np.where(np.isnan(rank), -np.inf, rank).argmax(axis=0)
        return np.asarray(np.take_along_axis(values, winner[None], axis=0)[0])
    index = aimed if choice == "as aimed" else Direction(CHOICES.index(choice) - 2)
    return np.asarray(stack[index], dtype=np.float32)


def span_of(
    kind: FieldKind, shown: Values, values: Values, snapshot: Snapshot, preferences: Preferences
) -> Span:
    """Colour range that a person chose for a field.

    Args:
        kind: The field.
        shown: The map that is drawn (H, W).
        values: All that was read of the field, (4, H, W) where it is directional.
        snapshot: Where reward and Q come from, if they share one range.
        preferences: The choice.
    """
    if kind.key == "mask":
        return 0.0, 1.0
    maps: Sequence[Values] = [shown]
    if kind.is_directional and preferences.span != "each field":
        maps = [values]
    if kind.key in {"reward", "q"} and preferences.span == "reward and Q":
        maps = [values, *_truth_and_belief(snapshot)]
    return value_span(*maps, is_diverging=kind.colormap.is_diverging)


def _truth_and_belief(snapshot: Snapshot) -> list[Values]:
    maps: list[Values] = []
    if snapshot.reward_map is not None:
        maps.append(snapshot.reward_map.values)
    if snapshot.policy is not None and snapshot.policy.q_map is not None:
        maps.append(snapshot.policy.q_map)
    return maps


def ingredients(snapshot: Snapshot, kind: FieldKind) -> tuple[object, ...]:
    """All of a snapshot that the picture of a field is made from.

    A field of an earlier scene stays as it is while blocks are dragged; its legend tells its age.
    """
    scene, truth, policy = snapshot.scene, snapshot.reward_map, snapshot.policy
    if kind.follows_run:
        run = snapshot.run
        return (run and (run.run_dir, run.revision),)
    if not kind.needs:
        return scene and scene.distance_map, scene and scene.rgb
    values = truth and truth.values, policy and policy.q_map, policy and policy.start_density
    return *values, truth and policy and truth.scene_version == policy.scene_version


def drape(snapshot: Snapshot, preferences: Preferences, workspace: Workspace) -> DrapedField | None:
    """The chosen field as a picture for the table, None where there is nothing to draw."""
    kind = FIELDS_BY_KEY[preferences.field]
    values = kind.read(snapshot, preferences, workspace)
    if values is None:
        return None
    if kind.key == "camera":
        image = picture_image(values.astype(np.uint8), preferences.opacity)
        return DrapedField(_crisp(image), kind.label, "")
    shown, label = values, kind.label
    if kind.is_directional:
        shown = select_direction(
            values, preferences.choice, preferences.direction, kind.colormap.is_diverging
        )
        label = f"{kind.label}, {_choice_text(kind, preferences)}"
    span = span_of(kind, shown, values, snapshot, preferences)
    image = field_image(shown, span, kind.colormap, preferences.opacity, kind.fades)
    legend = "" if kind.key == "mask" else legend_html(span, kind.colormap, kind.unit)
    return DrapedField(_crisp(image), label, legend)


def _crisp(image: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    return nearest(image, CRISP_SIZE).astype(np.uint8, copy=False)


def _choice_text(kind: FieldKind, preferences: Preferences) -> str:
    if preferences.choice == "best":
        return "largest error" if kind.colormap.is_diverging else "best direction"
    if preferences.choice == "as aimed":
        return preferences.direction.label
    return preferences.choice
