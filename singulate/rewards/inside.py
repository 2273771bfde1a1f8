"""r_Inside: marks pushes that start inside an object (paper, Eq. 5)."""


def inside_reward(is_inside: bool) -> float:
    """1 where the push starts inside an object, which no real gripper can do; otherwise 0.

    The penalty comes from the weight, which is negative.
    """
    return 1.0 if is_inside else 0.0
