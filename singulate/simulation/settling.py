"""Letting the blocks come to rest."""

import math
from collections.abc import Generator

from singulate.exceptions import SimulationError
from singulate.simulation.world import World


def settle(world: World) -> Generator[None, None, tuple[int, bool]]:
    """Step until all blocks are still, for a limited time; those that fell off are taken away.

    Yields:
        After each simulation step.

    Returns:
        Steps that it took, and whether everything is still.

    Raises:
        SimulationError: If a block is so fast that the physics went wrong.
    """
    max_steps = world.physics.max_settle_steps
    for i in range(max_steps):
        world.remove_fallen()
        speeds = world.block_speeds()
        _check(speeds, world.physics.max_speed)
        if is_still(speeds, world.physics.settle_speed):
            return i, True
        world.step()
        yield
    world.remove_fallen()
    return max_steps, False


def is_still(speeds: list[tuple[float, float]], limit: float) -> bool:
    """Whether no block moves faster than a limit [m/s], nor turns faster than ten of it [rad/s]."""
    return all(linear < limit and angular < 10 * limit for linear, angular in speeds)


def _check(speeds: list[tuple[float, float]], max_speed: float) -> None:
    for linear, angular in speeds:
        if not (linear < max_speed and math.isfinite(angular)):
            raise SimulationError(
                f"a block reached {linear:.3g} m/s; the scene is as before the push"
            )
