import numpy as np

from app.panels.curves import CHARTS, MAX_POINTS, chart_data, find_curve
from app.snapshot import Curve


def test_a_chart_shows_the_first_metric_that_the_run_has():
    curve = Curve(np.arange(3.0), np.arange(3.0))
    loss = next(spec for spec in CHARTS if spec.title == "Loss")
    assert find_curve(loss, {"train/value_loss": curve}) == ("train/value_loss", curve)
    assert find_curve(loss, {"train/value_loss": curve, "train/loss": curve}) == (
        "train/loss", curve,
    )  # fmt: skip
    assert find_curve(loss, {}) is None
    assert find_curve(loss, {"train/loss": Curve(np.zeros(0), np.zeros(0))}) is None


def test_long_curves_are_thinned_without_losing_their_mean_or_range():
    steps = np.arange(100_000, dtype=np.float64)
    thin, raw, smooth = chart_data(Curve(steps, np.sin(steps / 9000.0)))
    assert len(thin) == len(raw) == len(smooth) == MAX_POINTS
    assert (np.diff(thin) > 0).all()
    assert abs(raw.mean() - np.sin(steps / 9000.0).mean()) < 1e-3
    assert thin[0] < 300 and thin[-1] > 99_000


def test_values_that_are_not_finite_are_left_out():
    steps, raw, smooth = chart_data(Curve(np.arange(4.0), np.array([1.0, np.nan, np.inf, 3.0])))
    assert steps.tolist() == [0.0, 3.0]
    assert raw.tolist() == [1.0, 3.0]
    assert np.isfinite(smooth).all()


def test_smoothing_takes_the_noise_away_and_leaves_the_level():
    values = 5.0 + np.random.default_rng(0).standard_normal(400)
    _, raw, smooth = chart_data(Curve(np.arange(400.0), values))
    assert smooth.std() < 0.4 * raw.std()
    assert abs(smooth.mean() - 5.0) < 0.2


def test_an_empty_curve_stays_empty():
    assert all(len(part) == 0 for part in chart_data(Curve(np.zeros(0), np.zeros(0))))
