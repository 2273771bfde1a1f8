"""r_Dist: pays for moving objects apart (paper, Eq. 3)."""


def distance_reward(before_m: float, after_m: float) -> float:
    """Change of the truncated inter-object distance d_IOT through one push.

    Negative where segments came closer or merged. A segment that splits adds new pairs and so new
    summands to d_IOT.

    Args:
        before_m: d_IOT before the push [m].
        after_m: d_IOT after it [m].

    Returns:
        r_Dist [m].

    Example:
        >>> distance_reward(before_m=0.125, after_m=0.5)
        0.375
    """
    return after_m - before_m
