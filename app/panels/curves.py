"""Training curves made ready for a chart: found by name, thinned, smoothed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from app.snapshot import Curve

MAX_POINTS = 400
SMOOTHING_SHARE = 0.05
"""Width of the moving average as a share of the points that are drawn."""


@dataclass(frozen=True)
class ChartSpec:
    """One chart.

    Attributes:
        title: Name for people.
        names: Metrics that it can show, as `singulate.training` records them; the first that a run
            has is shown.
    """

    title: str
    names: tuple[str, ...]


CHARTS = (
    ChartSpec("Return", ("rollout/ep_rew_mean",)),
    ChartSpec("Success rate", ("rollout/success_rate",)),
    ChartSpec("Loss", ("train/loss", "train/value_loss", "train/critic_loss")),
    ChartSpec("Exploration rate", ("rollout/exploration_rate",)),
    ChartSpec("Entropy", ("train/entropy",)),
    ChartSpec("Episode length", ("rollout/ep_len_mean",)),
)


def find_curve(spec: ChartSpec, curves: Mapping[str, Curve]) -> tuple[str, Curve] | None:
    """Name and data of the metric that a chart shows, None where the run has none of them."""
    for name in spec.names:
        if name in curves and len(curves[name].steps):
            return name, curves[name]
    return None


def chart_data(curve: Curve) -> tuple[npt.NDArray[np.float64], ...]:
    """Steps, raw values and their moving average, float64 (N,) each with N <= `MAX_POINTS`.

    Long curves are thinned by averaging groups of neighbours, so that no part of a run is lost.
    """
    finite = np.isfinite(curve.values)
    steps, values = curve.steps[finite], curve.values[finite]
    if len(steps) > MAX_POINTS:
        groups = np.linspace(0, len(steps), MAX_POINTS + 1).astype(np.intp)
        counts = np.diff(groups)
        steps = np.add.reduceat(steps, groups[:-1]) / counts
        values = np.add.reduceat(values, groups[:-1]) / counts
    return steps, values, moving_average(values, max(1, round(len(values) * SMOOTHING_SHARE)))


def moving_average(
    values: Sequence[float] | npt.NDArray[np.float64], width: int
) -> npt.NDArray[np.float64]:
    """Mean of each value and up to `width` neighbours on both sides, float64 (N,).

    Example:
        >>> moving_average([0.0, 3.0, 6.0], 1)
        array([1.5, 3. , 4.5])
    """
    array = np.asarray(values, dtype=np.float64)
    total = np.concatenate([[0.0], np.cumsum(array)])
    index = np.arange(len(array))
    low, high = np.maximum(index - width, 0), np.minimum(index + width + 1, len(array))
    return np.asarray((total[high] - total[low]) / (high - low))
