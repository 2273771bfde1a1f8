"""Inter-object distances: one number for how far apart all segments are (paper, section 3.2.3)."""

import numpy as np
import numpy.typing as npt


def inter_object_distance(separations: npt.NDArray[np.float64]) -> float:
    """d_IO, the sum of all separations [m] (paper, Eq. 1); 0 without a pair.

    Example:
        >>> inter_object_distance(np.array([0.25, 0.5, 0.0]))
        0.75
    """
    return float(separations.sum())


def truncated_inter_object_distance(separations: npt.NDArray[np.float64], goal: float) -> float:
    """d_IOT, the sum of all separations, each counted up to the goal [m] (paper, Eq. 2).

    Args:
        separations: Edge-to-edge distance of each pair of segments, (K * (K - 1) / 2,) [m].
        goal: d_goal, the separation that is enough [m].

    Example:
        >>> truncated_inter_object_distance(np.array([0.25, 0.5, 0.0]), goal=0.375)
        0.625
    """
    return float(sum(min(separation, goal) for separation in separations.tolist()))
