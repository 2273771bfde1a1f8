"""One Bullet world: a table, a pusher and the blocks of one scene."""

import math
from collections.abc import Iterable, Iterator

from singulate.exceptions import SimulationError
from singulate.geometry import Poses, Workspace
from singulate.simulation.blocks import Blocks
from singulate.simulation.bodies import add_table
from singulate.simulation.boxes import Vector3
from singulate.simulation.bullet import pybullet
from singulate.simulation.motion import Motion, TopSpeeds
from singulate.simulation.physics import Physics
from singulate.simulation.pusher import Pusher

_PARK_EVERY = 100
"""In so many steps of 0.01 s the parked pusher falls by 5 m, which leaves it far above all else."""
_MAX_KEPT = 500
"""Scenes after which Bullet is started anew, since it frees little of what it has for a block."""
_TIGHT_RESIDUAL, _LOOSE_RESIDUAL = 1e-7, 1e-5
"""The solver stops once an iteration changes less than this; the first is Bullet's own."""


class World:
    """Owns one Bullet connection; must be used from the thread that made it.

    Bullet keeps contact caches and solver state between steps, so the outcome of a push would
    depend on what was simulated before it. `build` therefore makes all that moves anew. What takes
    most of the time of that, the table and the pusher and all that Bullet allocates around them,
    can stay: Bullet's simple broadphase finds the pairs of close bodies from where they are now
    alone, and blocks that are taken away in the reverse order leave its lists as they were before.
    Measured over 2,000 pushes in any order, the ends are those of a new world to the bit.

    Args:
        workspace: The square that the table covers.
        physics: Physical constants.
        is_kept: Whether table and pusher may stay from one scene to the next.
    """

    def __init__(self, workspace: Workspace, physics: Physics, is_kept: bool = True) -> None:
        self.client = pybullet.connect(pybullet.DIRECT)
        self.workspace = workspace
        self.physics = physics
        self._is_kept = is_kept
        self._residual = _TIGHT_RESIDUAL
        self._num_kept = 0
        self._untouched: Poses | None = None
        """The blocks that were put up and since then only looked at."""
        self._standing: Poses | None = None
        """Where the blocks stand, as long as that is known."""
        self._pusher: Pusher
        self._blocks: Blocks
        self._saved = -1
        self._num_parked_steps = 0

    def close(self) -> None:
        """Disconnect from Bullet; further calls do nothing."""
        if self.client >= 0:
            pybullet.disconnect(physicsClientId=self.client)
            self.client = -1

    def build(self, poses: Poses) -> None:
        """Put up the blocks at rest, with the pusher parked, as in a world that is new."""
        if poses != self._untouched:
            self._make(poses)
        self._untouched = self._standing = None

    def show(self, poses: Poses) -> None:
        """Put the blocks where they stand, for a picture, on which the pusher is never seen."""
        if poses is self._standing or poses == self._untouched:
            return
        if self._num_kept > 0 and self._blocks.fits(poses):
            self._untouched = None
            self._blocks.put(poses)
        else:
            self._make(poses)
            self._untouched = poses
        self._standing = poses

    def discard(self) -> None:
        """Let nothing stay for the next scene, because the physics went wrong."""
        self._num_kept = 0
        self._saved = -1
        self._untouched = self._standing = None

    def save(self) -> None:
        """Remember this moment for `go_back`, until the world is built again."""
        self._saved = pybullet.saveState(physicsClientId=self.client)

    def go_back(self) -> bool:
        """Return to the saved moment.

        Returns:
            Whether there is one.
        """
        if self._saved >= 0:
            pybullet.restoreState(stateId=self._saved, physicsClientId=self.client)
            self._blocks.forget_falls()
            self._standing = None
        return self._saved >= 0

    def place_pusher(self, x: float, y: float, z: float, yaw: float) -> None:
        """Put the pusher somewhere without a move, position of its centre [m] and yaw [rad]."""
        self._standing = None
        self._pusher.place(x, y, z, yaw)

    def park_pusher(self) -> None:
        """Take the pusher out of the scene and of the camera's view."""
        self._pusher.park()

    def drive_pusher(self, path: Iterable[Vector3]) -> Iterator[None]:
        """Advance by time steps, in each of which the pusher moves to the next point [m].

        Yields:
            After each time step.
        """
        self._standing = None
        return self._pusher.drive(path)

    def is_pusher_touching(self) -> bool:
        """Whether the pusher has touched a block in the last time step."""
        return self._pusher.is_touching()

    def pusher_pose(self) -> tuple[float, float, float, float]:
        """Position (x, y, z) [m] and yaw [rad] of the pusher."""
        return self._pusher.pose()

    def rest(self, num_steps: int) -> None:
        """Advance by a few time steps, up to 28, with the pusher parked.

        To the bits of as many `step`, in one call of Bullet; from 29 on, rounding may differ.
        """
        self._standing = None
        if num_steps > 0:
            self._set_time_step(num_steps)
            pybullet.stepSimulation(self.client)
            self._set_time_step(1)

    def step(self, num_steps: int = 1) -> None:
        """Advance by time steps with the pusher parked; it falls freely and is put back in time."""
        self._standing = None
        for _ in range(num_steps):
            if self._num_parked_steps % _PARK_EVERY == 0:
                self.park_pusher()
            self._num_parked_steps += 1
            pybullet.stepSimulation(self.client)

    def block_poses(self) -> Poses:
        """Poses of all blocks as they are now; a fallen block lies on the floor."""
        return self._blocks.poses()

    def checked_poses(self) -> Poses:
        """`block_poses` once the pusher is parked, as long as they are numbers.

        Raises:
            SimulationError: If one is not finite.
        """
        poses = self.block_poses()
        if not math.isfinite(sum(sum(pose.position) + sum(pose.quaternion) for pose in poses)):
            raise SimulationError("a block's pose is not finite; the scene is as before the push")
        self._standing = poses
        return poses

    def motion(self) -> Motion:
        """How the blocks move now; those that have left the table are taken away and still."""
        return self._blocks.motion()

    def set_motion(self, motion: Motion) -> None:
        """Let the blocks of this world move as in another one that was built alike."""
        if self._num_kept == 0:
            self.build(tuple(block.pose for block in motion))
        self._standing = None
        self._blocks.set_motion(motion)

    def loosen(self) -> None:
        """Let Bullet's solver stop earlier, until blocks are put up anew.

        Where no pusher drives the blocks any further, small errors stay small: they come to rest in
        half the time, and agree with plain pushes as well as under the tighter solver.
        """
        self._set_residual(_LOOSE_RESIDUAL)

    def top_speeds(self) -> TopSpeeds:
        """Speeds of the fastest blocks on the table."""
        return self._blocks.top_speeds()

    def take_away_fallen(self) -> None:
        """Take blocks that have left the table out of the way, down to the floor."""
        self._blocks.take_away_fallen()

    def _make(self, poses: Poses) -> None:
        if self._is_kept and 0 < self._num_kept < _MAX_KEPT:
            self._empty()
            self._set_residual(_TIGHT_RESIDUAL)
        else:
            self._start_anew()
        self._num_parked_steps = 0
        self._blocks = Blocks(self.client, poses, self.physics)

    def _empty(self) -> None:
        """Take all blocks away."""
        self._num_kept += 1
        if self._saved >= 0:
            pybullet.removeState(self._saved, physicsClientId=self.client)
            self._saved = -1
        self._blocks.remove()
        self.park_pusher()

    def _start_anew(self) -> None:
        """Put up the table and the parked pusher in a new world."""
        client, physics = self.client, self.physics
        flags = pybullet.RESET_USE_SIMPLE_BROADPHASE if self._is_kept else 0
        pybullet.resetSimulation(flags=flags, physicsClientId=client)
        self._num_kept = 1
        self._saved = -1
        self._residual = _TIGHT_RESIDUAL
        self._set_time_step(1)
        pybullet.setPhysicsEngineParameter(
            numSolverIterations=physics.solver_iterations,
            solverResidualThreshold=self._residual,
            deterministicOverlappingPairs=1,
            physicsClientId=client,
        )
        pybullet.setGravity(0, 0, -physics.gravity, physicsClientId=client)
        add_table(client, self.workspace, physics)
        self._pusher = Pusher(client, physics)

    def _set_residual(self, residual: float) -> None:
        if residual != self._residual:
            self._residual = residual
            pybullet.setPhysicsEngineParameter(
                solverResidualThreshold=residual, physicsClientId=self.client
            )

    def _set_time_step(self, num_substeps: int) -> None:
        """Let one call of Bullet advance so many time steps."""
        pybullet.setPhysicsEngineParameter(
            fixedTimeStep=self.physics.time_step * num_substeps,
            numSubSteps=num_substeps,
            physicsClientId=self.client,
        )
