"""Confidence interval of a share."""

import math

Z_95 = 1.959963984540054
"""0.975 quantile of the standard normal distribution."""


def wilson_interval(num_successes: int, num_trials: int, z: float = Z_95) -> tuple[float, float]:
    """Wilson score interval of a success probability (Wilson 1927).

    It stays within [0, 1] and is sensible even without a single success.

    Args:
        num_successes: Successes, 0 to `num_trials`.
        num_trials: Trials; with 0 nothing is known.
        z: Normal quantile of the confidence, 95 % by default.

    Returns:
        Lower and upper end.

    Example:
        >>> low, high = wilson_interval(5, 10)
        >>> round(low, 3), round(high, 3)
        (0.237, 0.763)
    """
    if num_trials == 0:
        return 0.0, 1.0
    share = num_successes / num_trials
    scale = 1.0 + z**2 / num_trials
    centre = (share + z**2 / (2.0 * num_trials)) / scale
    spread = math.sqrt(share * (1.0 - share) / num_trials + z**2 / (4.0 * num_trials**2))
    half_width = z * spread / scale
    low = 0.0 if num_successes == 0 else max(0.0, centre - half_width)
    high = 1.0 if num_successes == num_trials else min(1.0, centre + half_width)
    return low, high
