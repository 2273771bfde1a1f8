"""One push in a Bullet world, step by step."""

import math
from collections import deque
from collections.abc import Generator, Iterator

from singulate.exceptions import SimulationError
from singulate.simulation.boxes import Vector3
from singulate.simulation.schedule import PusherSchedule
from singulate.simulation.settling import check_speeds, is_still, num_moving_steps, settle
from singulate.simulation.world import World

MAX_PUSHER_ERROR = 0.02
"""A pusher further than this from its target means that the physics went wrong [m]."""

LEAD_STEPS = 3
"""Steps in which blocks that are put up begin to bear on their corners before the pusher comes:
its own first one is the fourth, and from then on the loads of the corners stay as they are."""


def simulate_push(
    world: World,
    schedule: PusherSchedule,
    num_clear_steps: int,
    *,
    is_exact: bool,
    is_watched: bool,
) -> Generator[None, None, tuple[int, bool]]:
    """Push blocks that have just been put up, and let them come to rest.

    Args:
        world: Holds the blocks.
        schedule: The push.
        num_clear_steps: Steps at its beginning that are left out, because no block is near.
        is_exact: Whether to simulate the whole retreat, even if the blocks lie still before.
        is_watched: Whether to stop after each time step and to lift the pusher to the end.

    Yields:
        After each time step that is not left out, where the push is watched.

    Returns:
        Time steps that the blocks took to settle once the pusher was gone, and whether they did.

    Raises:
        SimulationError: If the physics went wrong.
    """
    push, num_push_steps = schedule.push, schedule.num_push_steps
    world.rest(min(num_clear_steps, LEAD_STEPS))
    world.place_pusher(*schedule.position(num_clear_steps), push.yaw)
    yield from _drive(world, schedule.path(num_clear_steps, num_push_steps), is_watched)
    error = math.dist(world.pusher_pose()[:2], push.end)
    if not error < MAX_PUSHER_ERROR:
        raise SimulationError(
            f"the pusher stopped {error:.3g} m off its path; the scene is as before the push"
        )
    if is_exact:
        yield from _drive(world, schedule.path(num_push_steps, schedule.num_steps), is_watched)
    elif (yield from _retreat(world, schedule, is_watched)):
        return 0, True
    world.park_pusher()
    world.take_away_fallen()
    return (yield from settle(world, world.top_speeds(), is_watched=is_watched))


def _retreat(
    world: World, schedule: PusherSchedule, is_watched: bool
) -> Generator[None, None, bool]:
    """Lift the pusher; once the blocks lie still and it touches none, nothing is simulated.

    Returns:
        Whether it came to that.
    """
    physics, step, last = world.physics, schedule.num_push_steps, schedule.num_steps
    world.loosen()
    world.take_away_fallen()
    while step < last:
        speeds = world.top_speeds()
        check_speeds(speeds, physics.max_speed)
        if is_still(speeds, physics.settle_speed) and not world.is_pusher_touching():
            for position in schedule.path(step, last) if is_watched else ():
                world.place_pusher(*position, schedule.push.yaw)
                yield
            world.park_pusher()
            return True
        next_look = min(last, step + num_moving_steps(speeds, physics))
        yield from _drive(world, schedule.path(step, next_look), is_watched)
        step = next_look
    return False


def _drive(world: World, path: list[Vector3], is_watched: bool) -> Iterator[None]:
    """Move the pusher along a path; yields after each time step if somebody watches."""
    steps = world.drive_pusher(path)
    if is_watched:
        yield from steps
    else:
        deque(steps, maxlen=0)
