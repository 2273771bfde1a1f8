"""One Bullet world: a table, a pusher and the blocks of one scene."""

import math
from collections.abc import Iterable, Iterator

from singulate.exceptions import SimulationError
from singulate.geometry import BlockPose, Poses, Workspace
from singulate.simulation.bodies import add_blocks, add_table
from singulate.simulation.boxes import Vector3, move_body
from singulate.simulation.bullet import pybullet
from singulate.simulation.fallen import is_fallen, on_the_floor
from singulate.simulation.motion import BlockMotion, Motion, TopSpeeds
from singulate.simulation.physics import Physics
from singulate.simulation.pusher import Pusher

_PARK_EVERY = 100
"""In so many steps of 0.01 s the parked pusher falls by 5 m, which leaves it far above all else."""
_MAX_KEPT = 500
"""Scenes after which Bullet is started anew, since it frees little of what it has for a block."""
_ZERO = (0.0, 0.0, 0.0)
_GONE_X, _GONE_Z = 10.0, -100.0
"""Where fallen blocks go: under the table, each with so much room to the next [m]."""


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
        self._num_kept = 0
        self._untouched: Poses | None = None
        """The blocks that were put up and since then only looked at."""
        self._standing: Poses | None = None
        """Where the blocks stand, as long as that is known, with the pusher out of sight."""
        self._pusher: Pusher
        self._blocks: list[int | None] = []
        """Bodies; None of blocks that had fallen before."""
        self._sides: list[float] = []
        self._fallen: dict[int, BlockPose] = {}
        self._fallen_at_first: dict[int, BlockPose] = {}
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
        """Put the blocks where they stand, for a picture; the pusher is out of sight."""
        if poses is self._standing or poses == self._untouched:
            return
        if self._fits(poses):
            self._untouched = None
            self.park_pusher()
            for i, pose in enumerate(poses):
                self._put_block(i, pose)
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
            self._fallen = dict(self._fallen_at_first)
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

    def step(self) -> None:
        """Advance one time step with the pusher parked; it falls freely and is put back in time."""
        if self._num_parked_steps % _PARK_EVERY == 0:
            self.park_pusher()
        self._num_parked_steps += 1
        self._standing = None
        pybullet.stepSimulation(self.client)

    def block_poses(self) -> Poses:
        """Poses of all blocks as they are now; a fallen block lies on the floor."""
        fallen, read = self._fallen, self._read_pose
        return tuple([fallen[i] if i in fallen else read(i) for i in range(len(self._blocks))])

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
        return tuple(
            BlockMotion(pose)
            if i in self._fallen
            else BlockMotion(pose, *pybullet.getBaseVelocity(self._blocks[i], self.client))
            for i, pose in enumerate(self.take_away_fallen())
        )

    def set_motion(self, motion: Motion) -> None:
        """Let the blocks of this world move as in another one that was built alike."""
        if self._num_kept == 0:
            self.build(tuple(block.pose for block in motion))
        self._standing = None
        for i, (pose, velocity, spin) in enumerate(motion):
            self._put_block(i, pose)
            if i not in self._fallen:
                pybullet.resetBaseVelocity(self._blocks[i], velocity, spin, self.client)

    def top_speeds(self) -> TopSpeeds:
        """Speeds of the fastest blocks on the table."""
        linear = angular = 0.0
        for i, body in enumerate(self._blocks):
            if i not in self._fallen:
                (vx, vy, vz), (wx, wy, wz) = pybullet.getBaseVelocity(body, self.client)
                linear = _highest(linear, vx * vx + vy * vy + vz * vz)
                angular = _highest(angular, wx * wx + wy * wy + wz * wz)
        return TopSpeeds(math.sqrt(linear), math.sqrt(angular))

    def take_away_fallen(self) -> Poses:
        """Take blocks that have left the table out of the way, down to the floor.

        Returns:
            Poses of all blocks then.
        """
        poses = self.block_poses()
        if not any(map(is_fallen, poses)):
            return poses
        for i, pose in enumerate(poses):
            if i not in self._fallen and is_fallen(pose):
                self._put_block(i, on_the_floor(pose))
        return self.block_poses()

    def _read_pose(self, index: int) -> BlockPose:
        position, quaternion = pybullet.getBasePositionAndOrientation(
            self._blocks[index], self.client
        )
        return BlockPose(position, quaternion, self._sides[index])

    def _put_block(self, index: int, pose: BlockPose) -> None:
        """Move a block; the body of a fallen one falls on for ever, far from all others."""
        body = self._blocks[index]
        if is_fallen(pose):
            self._fallen[index] = pose
            if body is not None:
                move_body(self.client, body, (_GONE_X * (index + 1), 0.0, _GONE_Z))
        elif body is not None:
            self._fallen.pop(index, None)
            move_body(self.client, body, pose.position, pose.quaternion)

    def _fits(self, poses: Poses) -> bool:
        """Whether there are bodies for just these blocks, wherever they stand."""
        return (
            self._num_kept > 0
            and [pose.side for pose in poses] == self._sides
            and all(is_fallen(poses[i]) for i in self._fallen_at_first)
        )

    def _make(self, poses: Poses) -> None:
        if self._is_kept and 0 < self._num_kept < _MAX_KEPT:
            self._empty()
        else:
            self._start_anew()
        self._num_parked_steps = 0
        self._sides = [pose.side for pose in poses]
        self._fallen_at_first = {i: pose for i, pose in enumerate(poses) if is_fallen(pose)}
        self._fallen = dict(self._fallen_at_first)
        self._blocks = add_blocks(self.client, poses, self.physics)

    def _empty(self) -> None:
        """Take all blocks away."""
        self._num_kept += 1
        if self._saved >= 0:
            pybullet.removeState(self._saved, physicsClientId=self.client)
            self._saved = -1
        for body in reversed(self._blocks):
            if body is not None:
                pybullet.removeBody(body, physicsClientId=self.client)
        self.park_pusher()

    def _start_anew(self) -> None:
        """Put up the table and the parked pusher in a new world."""
        client, physics = self.client, self.physics
        flags = pybullet.RESET_USE_SIMPLE_BROADPHASE if self._is_kept else 0
        pybullet.resetSimulation(flags=flags, physicsClientId=client)
        self._num_kept = 1
        self._saved = -1
        self._set_time_step(1)
        pybullet.setPhysicsEngineParameter(
            numSolverIterations=physics.solver_iterations,
            deterministicOverlappingPairs=1,
            physicsClientId=client,
        )
        pybullet.setGravity(0, 0, -physics.gravity, physicsClientId=client)
        add_table(client, self.workspace, physics)
        self._pusher = Pusher(client, physics)

    def _set_time_step(self, num_substeps: int) -> None:
        """Let one call of Bullet advance so many time steps."""
        pybullet.setPhysicsEngineParameter(
            fixedTimeStep=self.physics.time_step * num_substeps,
            numSubSteps=num_substeps,
            physicsClientId=self.client,
        )


def _highest(one: float, other: float) -> float:
    """The higher of two numbers, or the one that is none."""
    return one if one > other or math.isnan(one) else other
