"""One Bullet world: a table, a pusher and the blocks of one scene."""

import itertools
import math

from singulate.exceptions import SimulationError
from singulate.geometry import BlockPose, Poses, Workspace
from singulate.simulation.bodies import (
    TABLE_THICKNESS,
    UPRIGHT,
    Vector3,
    add_solid_boxes,
    move_body,
)
from singulate.simulation.bullet import pybullet
from singulate.simulation.fallen import is_fallen, on_the_floor
from singulate.simulation.palette import block_colour
from singulate.simulation.physics import Physics

_PARKED_Z = 50.0
_PARK_EVERY = 100
"""In so many steps of 0.01 s the parked pusher falls by 5 m, which leaves it far above all else."""
_MAX_KEPT = 500
"""Scenes after which Bullet is started anew, since it frees little of what it has for a block."""
_ZERO = (0.0, 0.0, 0.0)

Motion = tuple[tuple[BlockPose, Vector3, Vector3], ...]
"""Pose, velocity [m/s] and angular velocity [rad/s] of each block."""


class World:
    """Owns one Bullet connection; must be used from the thread that made it.

    Bullet keeps contact caches and solver state between steps, so the outcome of a push would
    depend on what was simulated before it. `build` therefore makes all that moves anew. What takes
    most of the time of that, the table and the pusher and all that Bullet allocates around them,
    can stay: Bullet's simple broadphase finds the pairs of close bodies from where they are now
    alone, and blocks that are taken away in the reverse order leave its lists as they were before.
    Measured over 3,000 pushes in any order, the ends are those of a new world to the bit.

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
        self._pusher = -1
        self._blocks: list[int | None] = []
        self._fallen: dict[int, BlockPose] = {}
        self._sides: list[float] = []
        self._saved = -1
        self._num_fallen_at_first = 0
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
        self._untouched = None

    def show(self, poses: Poses) -> None:
        """Put the blocks where they stand, for a picture; the pusher is out of sight."""
        if poses == self._untouched:
            return
        if not self._fits(poses):
            self._make(poses)
            self._untouched = poses
            return
        self._untouched = None
        self.park_pusher()
        for body, pose in zip(self._blocks, poses, strict=True):
            if body is not None:
                move_body(self.client, body, pose.position, pose.quaternion)

    def _make(self, poses: Poses) -> None:
        if self._can_be_emptied():
            self._empty()
        else:
            self._start_anew()
        self._num_parked_steps = 0
        self._sides = [pose.side for pose in poses]
        self._fallen = {i: pose for i, pose in enumerate(poses) if is_fallen(pose)}
        self._num_fallen_at_first = len(self._fallen)
        self._blocks = self._add_blocks(poses)

    def discard(self) -> None:
        """Let nothing stay for the next scene, because the physics went wrong."""
        self._num_kept = 0
        self._saved = -1
        self._untouched = None

    def save(self) -> None:
        """Remember this moment for `go_back`, until the world is built again."""
        self._saved = pybullet.saveState(physicsClientId=self.client)

    def go_back(self) -> bool:
        """Return to the saved moment.

        Returns:
            Whether that was possible: a block that was taken away does not come back.
        """
        is_possible = self._saved >= 0 and len(self._fallen) == self._num_fallen_at_first
        if is_possible:
            pybullet.restoreState(stateId=self._saved, physicsClientId=self.client)
        return is_possible

    def place_pusher(self, x: float, y: float, z: float, yaw: float) -> None:
        """Put the pusher somewhere without a move, position of its centre [m] and yaw [rad]."""
        self._teleport_pusher((x, y, z), yaw)

    def is_pusher_touching(self) -> bool:
        """Whether the pusher has touched a block in the last time step."""
        return bool(pybullet.getContactPoints(self._pusher, physicsClientId=self.client))

    def park_pusher(self) -> None:
        """Take the pusher out of the scene and of the camera's view."""
        self._teleport_pusher((0.0, 0.0, _PARKED_Z), 0.0)

    def drive_pusher(self, x: float, y: float, z: float) -> None:
        """Advance one time step, in which the pusher moves to a position [m]."""
        pusher, client, dt = self._pusher, self.client, self.physics.time_step
        (px, py, pz), _ = pybullet.getBasePositionAndOrientation(pusher, client)
        velocity = ((x - px) / dt, (y - py) / dt, (z - pz) / dt)
        pybullet.resetBaseVelocity(pusher, velocity, _ZERO, client)
        pybullet.stepSimulation(client)

    def step(self) -> None:
        """Advance one time step with the pusher parked; it falls freely and is put back in time."""
        if self._num_parked_steps % _PARK_EVERY == 0:
            self.park_pusher()
        self._num_parked_steps += 1
        pybullet.stepSimulation(physicsClientId=self.client)

    def pusher_pose(self) -> tuple[float, float, float, float]:
        """Position (x, y, z) [m] and yaw [rad] of the pusher."""
        position, quaternion = pybullet.getBasePositionAndOrientation(
            self._pusher, physicsClientId=self.client
        )
        yaw = 2.0 * math.atan2(quaternion[2], quaternion[3])
        return position[0], position[1], position[2], yaw

    def block_poses(self) -> Poses:
        """Poses of all blocks as they are now; a fallen block lies on the floor."""
        return tuple(
            self._fallen[i] if body is None else self._block_pose(body, side)
            for i, (body, side) in enumerate(zip(self._blocks, self._sides, strict=True))
        )

    def checked_poses(self) -> Poses:
        """`block_poses`, as long as they are numbers.

        Raises:
            SimulationError: If one is not finite.
        """
        poses = self.block_poses()
        if not all(math.isfinite(v) for pose in poses for v in (*pose.position, *pose.quaternion)):
            raise SimulationError("a block's pose is not finite; the scene is as before the push")
        return poses

    def motion(self) -> Motion:
        """How the blocks move now; those that have fallen off are still."""
        return tuple(
            (pose, _ZERO, _ZERO)
            if body is None
            else (pose, *pybullet.getBaseVelocity(body, physicsClientId=self.client))
            for body, pose in zip(self._blocks, self.block_poses(), strict=True)
        )

    def set_motion(self, motion: Motion) -> None:
        """Let the blocks of this world move as in another one that was built alike."""
        poses = tuple(pose for pose, _, _ in motion)
        if self._num_kept == 0 or any(
            (body is None) != is_fallen(pose)
            for body, pose in zip(self._blocks, poses, strict=True)
        ):
            self.build(poses)
        for body, (pose, linear, angular) in zip(self._blocks, motion, strict=True):
            if body is not None:
                pybullet.resetBasePositionAndOrientation(
                    body, pose.position, pose.quaternion, physicsClientId=self.client
                )
                pybullet.resetBaseVelocity(body, linear, angular, physicsClientId=self.client)
        self._fallen = {i: pose for i, pose in enumerate(poses) if is_fallen(pose)}

    def block_speeds(self) -> list[tuple[float, float]]:
        """Speed [m/s] and turning speed [rad/s] of each block that is on the table."""
        speeds = []
        for body in self._blocks:
            if body is not None:
                linear, angular = pybullet.getBaseVelocity(body, physicsClientId=self.client)
                speeds.append((math.hypot(*linear), math.hypot(*angular)))
        return speeds

    def remove_fallen(self) -> None:
        """Take blocks that have left the table out of the simulation, down to the floor."""
        for i, body in enumerate(self._blocks):
            if body is None:
                continue
            pose = self._block_pose(body, self._sides[i])
            if is_fallen(pose):
                pybullet.removeBody(body, physicsClientId=self.client)
                self._blocks[i] = None
                self._fallen[i] = on_the_floor(pose)

    def _block_pose(self, body: int, side: float) -> BlockPose:
        position, quaternion = pybullet.getBasePositionAndOrientation(
            body, physicsClientId=self.client
        )
        return BlockPose(position, quaternion, side)

    def _fits(self, poses: Poses) -> bool:
        """Whether the bodies are those of these blocks, wherever they stand."""
        return (
            self._num_kept > 0
            and len(poses) == len(self._blocks)
            and all(
                pose.side == side and (body is None) == is_fallen(pose)
                for pose, side, body in zip(poses, self._sides, self._blocks, strict=True)
            )
        )

    def _can_be_emptied(self) -> bool:
        """Whether nothing has happened that would be remembered."""
        return (
            self._is_kept
            and 0 < self._num_kept < _MAX_KEPT
            and len(self._fallen) == self._num_fallen_at_first
        )

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
        pybullet.setPhysicsEngineParameter(
            fixedTimeStep=physics.time_step,
            numSolverIterations=physics.solver_iterations,
            deterministicOverlappingPairs=1,
            physicsClientId=client,
        )
        pybullet.setGravity(0, 0, -physics.gravity, physicsClientId=client)
        self._add_table()
        self._pusher = self._add_pusher()

    def _teleport_pusher(self, position: Vector3, yaw: float) -> None:
        quaternion = (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))
        pybullet.resetBasePositionAndOrientation(
            self._pusher, position, quaternion, physicsClientId=self.client
        )
        pybullet.resetBaseVelocity(self._pusher, _ZERO, _ZERO, physicsClientId=self.client)

    def _add_table(self) -> None:
        half = self.workspace.half_length
        add_solid_boxes(
            self.client,
            (half, half, TABLE_THICKNESS / 2),
            [((0.0, 0.0, -TABLE_THICKNESS / 2), UPRIGHT)],
            mass=0.0,
            friction=self.physics.table_friction,
        )

    def _add_pusher(self) -> int:
        physics = self.physics
        half = physics.pusher_side / 2
        (body,) = add_solid_boxes(
            self.client,
            (half, half, physics.pusher_height / 2),
            [((0.0, 0.0, _PARKED_Z), UPRIGHT)],
            mass=physics.pusher_mass,
            friction=physics.pusher_friction,
        )
        # Contacts must not turn the pusher: its inertia is as outsized as its mass.
        pybullet.changeDynamics(
            body,
            -1,
            mass=physics.pusher_mass,
            localInertiaDiagonal=[physics.pusher_mass] * 3,
            physicsClientId=self.client,
        )
        return body

    def _add_blocks(self, poses: Poses) -> list[int | None]:
        """Bodies of the blocks, None of fallen ones; neighbours of one side are made together."""
        physics = self.physics
        standing = [(i, pose) for i, pose in enumerate(poses) if not is_fallen(pose)]
        bodies: list[int | None] = [None] * len(poses)
        for side, neighbours in itertools.groupby(standing, key=lambda each: each[1].side):
            group = list(neighbours)
            made = add_solid_boxes(
                self.client,
                (side / 2,) * 3,
                [(pose.position, pose.quaternion) for _, pose in group],
                mass=physics.block_density * side**3,
                friction=physics.block_friction,
                colours=[block_colour(i) for i, _ in group],
            )
            for (i, _), body in zip(group, made, strict=True):
                bodies[i] = body
        return bodies
