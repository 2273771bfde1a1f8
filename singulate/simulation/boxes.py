"""Boxes in Bullet: solid ones for physics, visible ones for the camera.

Boxes of one size are added in one go: most of what a new body costs, Bullet pays once a call. Of
such boxes pybullet knows one number and takes the others for its neighbours. Bullet gives numbers
out again, the last one that came free first; so whoever removes boxes has to remove all of them, in
the reverse order of their making, before more are added.
"""

from collections.abc import Sequence

from singulate.simulation.bullet import pybullet
from singulate.simulation.palette import Colour

Vector3 = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Places = Sequence[tuple[Vector3, Quaternion]]
"""Position [m] and orientation of each body."""

UPRIGHT: Quaternion = (0.0, 0.0, 0.0, 1.0)
TABLE_THICKNESS = 0.1
"""[m]"""

OUT_OF_SIGHT: Vector3 = (0.0, 0.0, 100.0)
"""Above and behind every camera [m]."""

_ORIGIN: Vector3 = (0.0, 0.0, 0.0)
_SEEN_AS_ITS_SHAPE = -1
_NEVER_SLEEP = 4


def add_solid_boxes(
    client: int,
    half_extents: Vector3,
    places: Places,
    *,
    mass: float,
    friction: float,
    is_visible: bool = False,
) -> list[int]:
    """Add boxes of one size that take part in the physics.

    Args:
        client: The Bullet connection.
        half_extents: Half of the sides [m].
        places: Where each of them is.
        mass: Of each [kg]; 0 stands still.
        friction: Lateral friction coefficient.
        is_visible: Whether cameras see them, all white.
    """
    shape = pybullet.createCollisionShape(
        pybullet.GEOM_BOX, halfExtents=half_extents, physicsClientId=client
    )
    bodies = pybullet.createMultiBody(
        mass,
        shape,
        _SEEN_AS_ITS_SHAPE if is_visible else _unseen(client),
        batchPositions=[position for position, _ in places],
        # Plain rigid bodies step four times faster than Bullet's multibodies here.
        useMaximalCoordinates=True,
        physicsClientId=client,
    )
    for body, (position, quaternion) in zip(bodies, places, strict=True):
        if quaternion != UPRIGHT:
            move_body(client, body, position, quaternion)
        pybullet.changeDynamics(
            body, -1, lateralFriction=friction, activationState=_NEVER_SLEEP, physicsClientId=client
        )
    return list(bodies)


def add_visible_boxes(client: int, half_extents: Vector3, colours: Sequence[Colour]) -> list[int]:
    """Add boxes of one size at the origin that cameras see and that nothing collides with."""
    shape = pybullet.createVisualShape(
        pybullet.GEOM_BOX,
        halfExtents=half_extents,
        specularColor=(0.1, 0.1, 0.1),
        physicsClientId=client,
    )
    bodies = pybullet.createMultiBody(
        0.0,
        baseVisualShapeIndex=shape,
        batchPositions=[_ORIGIN] * len(colours),
        physicsClientId=client,
    )
    for body, colour in zip(bodies, colours, strict=True):
        pybullet.changeVisualShape(body, -1, rgbaColor=colour, physicsClientId=client)
    return list(bodies)


def move_body(client: int, body: int, position: Vector3, quaternion: Quaternion = UPRIGHT) -> None:
    """Put a body somewhere, at once."""
    pybullet.resetBasePositionAndOrientation(body, position, quaternion, physicsClientId=client)


def _unseen(client: int) -> int:
    """A visual shape so transparent that the renderer leaves it out."""
    return int(
        pybullet.createVisualShape(
            pybullet.GEOM_BOX,
            halfExtents=(0.001, 0.001, 0.001),
            rgbaColor=(0.0, 0.0, 0.0, 0.0),
            physicsClientId=client,
        )
    )
