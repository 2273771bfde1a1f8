"""Letting the blocks come to rest."""

import math
from collections.abc import Generator

from singulate.exceptions import SimulationError
from singulate.simulation.motion import TopSpeeds
from singulate.simulation.physics import Physics
from singulate.simulation.world import World

_MAX_UNSEEN_STEPS = 8
"""Blocks that fall off the table, and are never still, are taken away this often."""


def settle(
    world: World, speeds: TopSpeeds, *, is_watched: bool
) -> Generator[None, None, tuple[int, bool]]:
    """Step until all blocks are still, for a limited time; those that fell off are taken away.

    Args:
        world: Holds the blocks; its pusher is parked.
        speeds: Of the fastest blocks at the beginning; those that fell off have been taken away.
        is_watched: Whether to stop after each time step.

    Yields:
        After each time step, where somebody watches.

    Returns:
        Steps that it took, and whether everything is still.

    Raises:
        SimulationError: If a block is so fast that the physics went wrong.
    """
    physics = world.physics
    num_steps, looked_at = 0, 0
    while True:
        check_speeds(speeds, physics.max_speed)
        if is_still(speeds, physics.settle_speed):
            return num_steps, True
        if num_steps == physics.max_settle_steps:
            return num_steps, False
        num_more = min(num_moving_steps(speeds, physics), physics.max_settle_steps - num_steps)
        if is_watched:
            for _ in range(num_more):
                world.step()
                yield
        else:
            world.step(num_more)
        num_steps += num_more
        if num_steps - looked_at >= _MAX_UNSEEN_STEPS or num_steps == physics.max_settle_steps:
            world.take_away_fallen()
            looked_at = num_steps
        speeds = world.top_speeds()


def is_still(speeds: TopSpeeds, limit: float) -> bool:
    """Whether no block moves faster than a limit [m/s], nor turns faster than ten of it [rad/s]."""
    return speeds.linear < limit and speeds.angular < 10 * limit


def num_moving_steps(speeds: TopSpeeds, physics: Physics) -> int:
    """Steps that friction with the table alone takes to stop the fastest block; at least one.

    A block that something else stops sooner merely lies still for a while.
    """
    num_steps = math.ceil((speeds.linear - physics.settle_speed) / physics.sliding_loss)
    return min(max(num_steps, 1), _MAX_UNSEEN_STEPS)


def check_speeds(speeds: TopSpeeds, max_speed: float) -> None:
    """Raise a `SimulationError` if a block is so fast that the physics went wrong."""
    if not (speeds.linear < max_speed and math.isfinite(speeds.angular)):
        raise SimulationError(
            f"a block reached {speeds.linear:.3g} m/s; the scene is as before the push"
        )
