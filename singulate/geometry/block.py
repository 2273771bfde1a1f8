"""Blocks: where a scene puts them, and where physics has moved them."""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import NamedTuple

from singulate.exceptions import InvalidValueError
from singulate.geometry.rectangle import Polygon, penetration, rectangle
from singulate.geometry.workspace import Workspace

MIN_SIDE = 0.05
MAX_SIDE = 0.5
MAX_BLOCKS = 16
TOUCH_TOLERANCE = 1e-4
"""Blocks that touch may overlap by this much through rounding [m]."""


@dataclass(frozen=True)
class Block:
    """A cube that stands on the table.

    Attributes:
        x: Centre [m].
        y: Centre [m].
        side: Edge length [m].
        yaw: Turn about the vertical, counter-clockwise [rad].
    """

    x: float
    y: float
    side: float = 0.2
    yaw: float = 0.0

    @property
    def footprint(self) -> Polygon:
        """Corners on the table, shape (4, 2) [m]."""
        return rectangle((self.x, self.y), (self.side / 2, self.side / 2), self.yaw)


Layout = tuple[Block, ...]
"""The blocks of a scene before anything has moved."""


class BlockPose(NamedTuple):
    """Full pose of a block, which may have been tipped over.

    Attributes:
        position: Centre (x, y, z) [m].
        quaternion: Orientation (x, y, z, w).
        side: Edge length [m].
    """

    position: tuple[float, float, float]
    quaternion: tuple[float, float, float, float]
    side: float

    @property
    def yaw(self) -> float:
        """Turn about the vertical of a block that stands upright [rad]."""
        x, y, z, w = self.quaternion
        return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


Poses = tuple[BlockPose, ...]
"""The state of a scene at rest: all that the next push depends on."""


def standing_pose(block: Block) -> BlockPose:
    """Pose of a block that stands upright on the table as its layout says."""
    half = block.yaw / 2
    return BlockPose(
        (block.x, block.y, block.side / 2),
        (0.0, 0.0, math.sin(half), math.cos(half)),
        block.side,
    )


def parse_layout(blocks: object, workspace: Workspace) -> Layout:
    """Check blocks that came from outside.

    Args:
        blocks: A sequence of mappings with ``x``, ``y`` and optionally ``side`` and ``yaw``.
        workspace: The square that the blocks have to stand in.

    Returns:
        The same blocks, checked.

    Raises:
        InvalidValueError: If a key is unknown or missing, a value is not a finite number or out of
            range, a block reaches over the table's edge, or two blocks overlap.
    """
    if isinstance(blocks, str | Mapping) or not isinstance(blocks, Sequence):
        raise InvalidValueError("blocks", blocks, "a list of {x, y, side, yaw}")
    if not 1 <= len(blocks) <= MAX_BLOCKS:
        raise InvalidValueError("blocks", f"{len(blocks)} blocks", f"1 to {MAX_BLOCKS} blocks")
    layout = tuple(_parse_block(i, block) for i, block in enumerate(blocks))
    _check_on_table(layout, workspace)
    _check_apart(layout)
    return layout


def layout_to_dicts(layout: Iterable[Block]) -> list[dict[str, float]]:
    """The inverse of `parse_layout`."""
    return [asdict(block) for block in layout]


def _parse_block(index: int, block: object) -> Block:
    if isinstance(block, Block):
        block = asdict(block)
    if not isinstance(block, Mapping):
        raise InvalidValueError(f"blocks[{index}]", block, "a mapping with x, y, side, yaw")
    unknown = sorted(set(block) - {"x", "y", "side", "yaw"}, key=str)
    if unknown:
        raise InvalidValueError(f"blocks[{index}]", unknown[0], "the keys x, y, side, yaw")
    for key in ("x", "y"):
        if key not in block:
            raise InvalidValueError(f"blocks[{index}].{key}", None, "a number [m]")
    values = {key: _number(f"blocks[{index}].{key}", value) for key, value in block.items()}
    parsed = Block(**values)
    if not MIN_SIDE <= parsed.side <= MAX_SIDE:
        raise InvalidValueError(
            f"blocks[{index}].side", parsed.side, f"{MIN_SIDE} to {MAX_SIDE} [m]"
        )
    return parsed


def _number(key: str, value: object) -> float:
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        raise InvalidValueError(key, value, "a finite number") from None
    if isinstance(value, bool | str) or not math.isfinite(number):
        raise InvalidValueError(key, value, "a finite number")
    return number


def _check_on_table(layout: Layout, workspace: Workspace) -> None:
    for i, block in enumerate(layout):
        reach = float(abs(block.footprint).max())
        if reach > workspace.half_length + TOUCH_TOLERANCE:
            raise InvalidValueError(
                f"blocks[{i}]",
                f"a block reaching to {reach:.3f} m",
                f"all corners within {workspace.half_length} m of the centre lines",
            )


def _check_apart(layout: Layout) -> None:
    footprints = [block.footprint for block in layout]
    for i in range(len(layout)):
        for j in range(i):
            depth = penetration(footprints[i], footprints[j])
            if depth > TOUCH_TOLERANCE:
                raise InvalidValueError(
                    f"blocks[{j}], blocks[{i}]",
                    f"an overlap of {depth:.4f} m",
                    f"blocks that touch or stand apart (overlap up to {TOUCH_TOLERANCE} m)",
                )
