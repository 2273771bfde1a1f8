"""The pusher: a heavy box that is driven along a path, and kept out of sight otherwise."""

import math
from collections.abc import Iterable, Iterator

from singulate.simulation.bodies import add_pusher
from singulate.simulation.boxes import Vector3
from singulate.simulation.bullet import pybullet
from singulate.simulation.physics import Physics

_PARKED_Z = 50.0
_ZERO = (0.0, 0.0, 0.0)


class Pusher:
    """Puts the pusher's body into a Bullet world, parked, and moves it.

    Args:
        client: The Bullet connection.
        physics: Physical constants.
    """

    def __init__(self, client: int, physics: Physics) -> None:
        self._client = client
        self._time_step = physics.time_step
        self._body = add_pusher(client, physics, _PARKED_Z)

    def place(self, x: float, y: float, z: float, yaw: float) -> None:
        """Put it somewhere without a move, position of its centre [m] and yaw [rad]."""
        quaternion = (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))
        pybullet.resetBasePositionAndOrientation(
            self._body, (x, y, z), quaternion, physicsClientId=self._client
        )
        pybullet.resetBaseVelocity(self._body, _ZERO, _ZERO, physicsClientId=self._client)

    def park(self) -> None:
        """Take it out of the scene and of the camera's view; from there it falls freely."""
        self.place(0.0, 0.0, _PARKED_Z, 0.0)

    def drive(self, path: Iterable[Vector3]) -> Iterator[None]:
        """Advance the world by time steps, in each of which its centre moves to the next point [m].

        Yields:
            After each time step.
        """
        body, client, dt = self._body, self._client, self._time_step
        read = pybullet.getBasePositionAndOrientation
        set_velocity, step = pybullet.resetBaseVelocity, pybullet.stepSimulation
        for x, y, z in path:
            (px, py, pz), _ = read(body, client)
            set_velocity(body, ((x - px) / dt, (y - py) / dt, (z - pz) / dt), _ZERO, client)
            step(client)
            yield

    def pose(self) -> tuple[float, float, float, float]:
        """Position (x, y, z) [m] and yaw [rad]."""
        position, quaternion = pybullet.getBasePositionAndOrientation(
            self._body, physicsClientId=self._client
        )
        yaw = 2.0 * math.atan2(quaternion[2], quaternion[3])
        return position[0], position[1], position[2], yaw

    def is_touching(self) -> bool:
        """Whether it has touched a block in the last time step."""
        return bool(pybullet.getContactPoints(self._body, physicsClientId=self._client))
