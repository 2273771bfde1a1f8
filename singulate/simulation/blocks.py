"""The blocks of a scene in Bullet: where they are and how they move."""

from singulate.geometry import BlockPose, Poses
from singulate.simulation.bodies import add_blocks
from singulate.simulation.boxes import move_body
from singulate.simulation.bullet import pybullet
from singulate.simulation.fallen import is_fallen, on_the_floor
from singulate.simulation.motion import BlockMotion, Motion, TopSpeeds, fastest
from singulate.simulation.physics import Physics
from singulate.simulation.resting import resting_place

_GONE_X, _GONE_Z = 10.0, -100.0
"""Where fallen blocks go: under the table, each with so much room to the next [m]."""


class Blocks:
    """Puts the bodies of some blocks into a Bullet world and keeps track of those that fall off.

    Args:
        client: The Bullet connection.
        poses: The blocks at rest; those that have fallen before get no body.
        physics: Physical constants.
    """

    def __init__(self, client: int, poses: Poses, physics: Physics) -> None:
        self._client = client
        self._sides = [pose.side for pose in poses]
        self._fallen_at_first = {i: pose for i, pose in enumerate(poses) if is_fallen(pose)}
        self._fallen = dict(self._fallen_at_first)
        self._bodies = add_blocks(client, poses, physics)

    def remove(self) -> None:
        """Take all bodies away, in the reverse order, which leaves Bullet's lists as before."""
        for body in reversed(self._bodies):
            if body is not None:
                pybullet.removeBody(body, physicsClientId=self._client)

    def fits(self, poses: Poses) -> bool:
        """Whether there are bodies for just these blocks, wherever they stand."""
        return [pose.side for pose in poses] == self._sides and all(
            is_fallen(poses[i]) for i in self._fallen_at_first
        )

    def forget_falls(self) -> None:
        """Take the blocks for fallen that were so at first, because Bullet has gone back."""
        self._fallen = dict(self._fallen_at_first)

    def poses(self) -> Poses:
        """Where all blocks are now; a fallen one lies on the floor."""
        fallen, read = self._fallen, self._read_pose
        return tuple([fallen[i] if i in fallen else read(i) for i in range(len(self._bodies))])

    def put(self, poses: Poses) -> None:
        """Move all blocks, at once."""
        for i, pose in enumerate(poses):
            self._put_one(i, pose)

    def motion(self) -> Motion:
        """How the blocks move now; those that have left the table are taken away and still."""
        return tuple(
            BlockMotion(pose)
            if i in self._fallen
            else BlockMotion(pose, *pybullet.getBaseVelocity(self._bodies[i], self._client))
            for i, pose in enumerate(self.take_away_fallen())
        )

    def set_motion(self, motion: Motion) -> None:
        """Let the blocks move like that."""
        for i, (pose, velocity, spin) in enumerate(motion):
            self._put_one(i, pose)
            if i not in self._fallen:
                pybullet.resetBaseVelocity(self._bodies[i], velocity, spin, self._client)

    def top_speeds(self) -> TopSpeeds:
        """Speeds of the fastest blocks on the table."""
        return fastest(
            [
                pybullet.getBaseVelocity(body, self._client)
                for i, body in enumerate(self._bodies)
                if i not in self._fallen
            ]
        )

    def take_away_fallen(self) -> Poses:
        """Take blocks that have left the table out of the way, down to the floor.

        Returns:
            Poses of all blocks then.
        """
        poses = self.poses()
        if not any(map(is_fallen, poses)):
            return poses
        for i, pose in enumerate(poses):
            if i not in self._fallen and is_fallen(pose):
                self._put_one(i, on_the_floor(pose))
        return self.poses()

    def _read_pose(self, index: int) -> BlockPose:
        position, quaternion = pybullet.getBasePositionAndOrientation(
            self._bodies[index], self._client
        )
        return BlockPose(position, quaternion, self._sides[index])

    def _put_one(self, index: int, pose: BlockPose) -> None:
        """Move a block; the body of a fallen one falls on for ever, far from all others."""
        body = self._bodies[index]
        if is_fallen(pose):
            self._fallen[index] = pose
            if body is not None:
                move_body(self._client, body, (_GONE_X * (index + 1), 0.0, _GONE_Z))
        elif body is not None:
            self._fallen.pop(index, None)
            move_body(self._client, body, *resting_place(pose))
