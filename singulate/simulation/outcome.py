"""What a push did to the table, and how it looks on the way."""

from dataclasses import dataclass
from typing import NamedTuple

from singulate.geometry import Poses


@dataclass(frozen=True)
class PushOutcome:
    """What happened on the table.

    Attributes:
        is_blocked: The pusher would have been lowered onto a block; nothing was simulated.
        is_touching: The strip that the pusher sweeps meets a block; otherwise nothing moves.
        is_settled: Everything was still at the end.
        fallen: Indices of the blocks that this push sent off the table.
        moved: Largest displacement of a block [m].
        num_steps: Time steps that it took; the free approach counts, though it is not simulated.
    """

    is_blocked: bool = False
    is_touching: bool = False
    is_settled: bool = True
    fallen: tuple[int, ...] = ()
    moved: float = 0.0
    num_steps: int = 0


class PushFrame(NamedTuple):
    """One moment of a push: block poses, and the pusher's (x, y, z) [m] and yaw [rad]."""

    poses: Poses
    pusher: tuple[float, float, float, float]
