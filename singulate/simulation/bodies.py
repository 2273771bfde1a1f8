"""Boxes in Bullet: solid ones for physics, visible ones for the camera."""

from singulate.simulation.bullet import pybullet

Vector3 = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Colour = tuple[float, float, float, float]

UPRIGHT: Quaternion = (0.0, 0.0, 0.0, 1.0)
TABLE_THICKNESS = 0.1
"""[m]"""

_NEVER_SLEEP = 4


def add_solid_box(
    client: int,
    half_extents: Vector3,
    position: Vector3,
    quaternion: Quaternion = UPRIGHT,
    *,
    mass: float,
    friction: float,
) -> int:
    """Add a box that takes part in the physics; mass 0 stands still [kg]."""
    shape = pybullet.createCollisionShape(
        pybullet.GEOM_BOX, halfExtents=half_extents, physicsClientId=client
    )
    body = pybullet.createMultiBody(
        mass,
        shape,
        basePosition=position,
        baseOrientation=quaternion,
        # Plain rigid bodies step four times faster than Bullet's multibodies here.
        useMaximalCoordinates=True,
        physicsClientId=client,
    )
    pybullet.changeDynamics(
        body, -1, lateralFriction=friction, activationState=_NEVER_SLEEP, physicsClientId=client
    )
    return int(body)


def add_visible_box(
    client: int, half_extents: Vector3, position: Vector3, quaternion: Quaternion, colour: Colour
) -> int:
    """Add a box that cameras see and that nothing collides with."""
    shape = pybullet.createVisualShape(
        pybullet.GEOM_BOX,
        halfExtents=half_extents,
        rgbaColor=colour,
        specularColor=(0.1, 0.1, 0.1),
        physicsClientId=client,
    )
    body = pybullet.createMultiBody(
        0.0,
        baseVisualShapeIndex=shape,
        basePosition=position,
        baseOrientation=quaternion,
        physicsClientId=client,
    )
    return int(body)
