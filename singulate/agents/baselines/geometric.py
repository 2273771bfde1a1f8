"""A linear push along the boundary between two presumed blocks, from the mask alone.

Hand-made singulation (such as Hermans, Rehg and Bobick, *Guided pushing for object singulation*,
2012) looks for edges at which a blob may fall into two objects, and pushes along such an edge, so
that one side slides past the other.
"""

import numpy as np
import numpy.typing as npt

from singulate.agents.baselines.observed_mask import boxes_with_points, mask_of, object_points
from singulate.agents.baselines.presumed_blocks import PresumedBlock, presume_blocks
from singulate.agents.policy import FloatMap
from singulate.geometry import Direction, Push, Workspace
from singulate.simulation import Physics

START_CLEARANCE = 0.05
"""Between the pusher and the block that it is to push [m]; more than a pixel of 31 mm."""
NEIGHBOUR_GAP = 0.1
"""Blocks closer than this are neighbours that have to be parted: d_goal of Eq. 2 [m]."""
BLOCKED_START = 16.0
"""What a start on an object costs: more than all else together."""

Candidate = tuple[float, Push]
"""How good a push looks, and the push."""


class GeometricPolicy:
    """Shears one presumed block out of its blob.

    Each presumed block can be pushed through its middle in four directions. Along a boundary the
    push shears it off the neighbours at its sides, the more of them the better; a block in front
    would be pushed along, and a block behind leaves no room for the pusher. Among equals, the push
    that keeps the block closest to the middle of the table is taken.
    """

    kind = "geometric"
    is_random = False

    def __init__(self, observation: str = "distance_map", workspace: Workspace | None = None):
        self.observation = observation
        self.workspace = workspace or Workspace()
        self._pusher_side = Physics().pusher_side

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """The push along a boundary that looks best; the generator has no effect."""
        mask = mask_of(observation, self.observation)
        blocks = presume_blocks(mask)
        if not blocks:
            return Push.cardinal((0.0, 0.0), Direction.UP, self.workspace.push_length)
        candidates = [
            self._candidate(block, blocks, direction) for block in blocks for direction in Direction
        ]
        scores = np.array([score for score, _ in candidates])
        scores -= BLOCKED_START * self._are_blocked([push for _, push in candidates], mask)
        return candidates[int(scores.argmax())][1]

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """None: it expects nothing."""
        return None

    def _candidate(
        self, block: PresumedBlock, blocks: list[PresumedBlock], direction: Direction
    ) -> Candidate:
        workspace = self.workspace
        pixel = workspace.metres_per_pixel
        forward = np.array(direction.vector)
        centre = np.array(workspace.row_col_to_xy(block.row, block.col))
        back = (block.side * pixel + self._pusher_side) / 2 + START_CLEARANCE
        start = centre - back * forward
        end = centre + (workspace.push_length - back) * forward
        num_sides = num_ahead = num_behind = 0
        for other in blocks:
            if other is not block:
                offset = np.array(workspace.row_col_to_xy(other.row, other.col)) - centre
                gap = (block.side + other.side) / 2 * pixel + NEIGHBOUR_GAP
                along, across = self._relative(offset, forward)
                is_near = max(abs(along), across) < gap
                is_aside = across > abs(along)
                num_sides += is_near and is_aside
                num_ahead += is_near and not is_aside and along > 0.0
                num_behind += is_near and not is_aside and along < 0.0
        is_outside = float(np.abs([start, end]).max()) > workspace.half_length
        score = num_sides - 2.0 * num_ahead - 4.0 * num_behind - 8.0 * is_outside
        score -= 0.1 * float(np.linalg.norm(end))
        push = Push.cardinal((float(start[0]), float(start[1])), direction, workspace.push_length)
        return score, push

    def _are_blocked(
        self, pushes: list[Push], mask: npt.NDArray[np.bool_]
    ) -> npt.NDArray[np.bool_]:
        """Which pushes start on an object, (N,)."""
        starts = np.array([push.start for push in pushes])
        pixel = self.workspace.metres_per_pixel
        half = np.full_like(starts, (self._pusher_side + pixel) / 2)  # a pixel's edge counts
        return boxes_with_points(starts, half, object_points(mask, pixel))

    @staticmethod
    def _relative(
        offset: npt.NDArray[np.float64], forward: npt.NDArray[np.float64]
    ) -> tuple[float, float]:
        """How far another block lies ahead (signed), and how far to the side [m]."""
        along = float(offset @ forward)
        across = float(np.linalg.norm(offset - along * forward))
        return along, across
