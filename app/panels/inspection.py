"""A clicked cell: true and predicted reward of all directions."""

import math

from app.panels.markup import block, dimmed, table, title
from app.panels.montage import ARROWS
from app.snapshot import Snapshot
from singulate.geometry import Direction, Workspace


def inspection_html(
    snapshot: Snapshot, place: tuple[float, float] | None, workspace: Workspace
) -> str:
    """Values of every direction at a place on the table."""
    if place is None:
        return block(title("Inspect"), dimmed("Click a place on the table."))
    x, y = place
    lines = [title(f"Inspect ({x:.2f}, {y:.2f}) m")]
    if snapshot.scene is not None:
        cell = workspace.xy_to_row_col(x, y, snapshot.scene.distance_map.shape[0])
        pixels = float(snapshot.scene.distance_map[cell])
        metres = pixels * workspace.metres_per_pixel
        inside = "inside a block" if pixels < 0 else f"{metres:.2f} m from the nearest block"
        lines.append(dimmed(inside))
    rows = []
    for direction in Direction:
        truth, belief = _at(snapshot, direction, place, workspace)
        rows.append((ARROWS[direction], _text(truth), _text(belief), _signed(belief - truth)))
    lines.append(table(rows, ("", "reward", "Q", "Q \N{MINUS SIGN} r")))
    return block(*lines)


def _at(
    snapshot: Snapshot, direction: Direction, place: tuple[float, float], workspace: Workspace
) -> tuple[float, float]:
    truth = belief = math.nan
    if snapshot.reward_map is not None:
        values = snapshot.reward_map.values
        truth = float(values[direction][workspace.xy_to_row_col(*place, values.shape[1])])
    if snapshot.policy is not None and snapshot.policy.q_map is not None:
        values = snapshot.policy.q_map
        belief = float(values[direction][workspace.xy_to_row_col(*place, values.shape[1])])
    return truth, belief


def _text(value: float) -> str:
    return f"{value:.0f}" if math.isfinite(value) else "\N{EN DASH}"


def _signed(value: float) -> str:
    return f"{value:+.0f}" if math.isfinite(value) else ""
