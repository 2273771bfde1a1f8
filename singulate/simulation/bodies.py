"""The bodies of a scene in Bullet: the table, the pusher and the blocks."""

import itertools

from singulate.geometry import Poses, Workspace
from singulate.simulation.boxes import TABLE_THICKNESS, UPRIGHT, add_solid_boxes
from singulate.simulation.bullet import pybullet
from singulate.simulation.fallen import is_fallen
from singulate.simulation.physics import Physics
from singulate.simulation.resting import resting_place, solid_half_extents


def add_table(client: int, workspace: Workspace, physics: Physics) -> None:
    """Add the table, unseen by cameras."""
    half = workspace.half_length
    add_solid_boxes(
        client,
        (half, half, TABLE_THICKNESS / 2),
        [((0.0, 0.0, -TABLE_THICKNESS / 2), UPRIGHT)],
        mass=0.0,
        friction=physics.table_friction,
    )


def add_pusher(client: int, physics: Physics, z: float) -> int:
    """Add the pusher above the table's centre, unseen by cameras; z is its centre's height [m]."""
    half = physics.pusher_side / 2
    (body,) = add_solid_boxes(
        client,
        (half, half, physics.pusher_height / 2),
        [((0.0, 0.0, z), UPRIGHT)],
        mass=physics.pusher_mass,
        friction=physics.pusher_friction,
    )
    # Contacts must not turn the pusher: its inertia is as outsized as its mass.
    pybullet.changeDynamics(
        body,
        -1,
        mass=physics.pusher_mass,
        localInertiaDiagonal=[physics.pusher_mass] * 3,
        physicsClientId=client,
    )
    return body


def add_blocks(client: int, poses: Poses, physics: Physics) -> list[int | None]:
    """Add the blocks, seen by cameras.

    Returns:
        Body of each block, None of fallen ones; neighbours of one side are made together.
    """
    standing = [(i, pose) for i, pose in enumerate(poses) if not is_fallen(pose)]
    bodies: list[int | None] = [None] * len(poses)
    for side, neighbours in itertools.groupby(standing, key=lambda each: each[1].side):
        group = list(neighbours)
        made = add_solid_boxes(
            client,
            solid_half_extents(side),
            [resting_place(pose) for _, pose in group],
            mass=physics.block_density * side**3,
            friction=physics.block_friction,
            is_visible=True,
        )
        for (i, _), body in zip(group, made, strict=True):
            bodies[i] = body
    return bodies
