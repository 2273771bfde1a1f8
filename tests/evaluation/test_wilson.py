import pytest

from singulate.evaluation import wilson_interval


@pytest.mark.parametrize(
    ("successes", "trials", "low", "high"),
    [(0, 10, 0.0, 0.2775), (10, 10, 0.7225, 1.0), (580, 1000, 0.5492, 0.6103), (0, 0, 0.0, 1.0)],
)
def test_known_intervals(successes: int, trials: int, low: float, high: float) -> None:
    assert wilson_interval(successes, trials) == pytest.approx((low, high), abs=1e-4)


def test_it_holds_the_true_share_95_times_in_100() -> None:
    """Exact coverage for 40 trials at a share of 0.3, summed over the binomial distribution."""
    import math

    share, trials = 0.3, 40
    coverage = sum(
        math.comb(trials, k) * share**k * (1 - share) ** (trials - k)
        for k in range(trials + 1)
        if wilson_interval(k, trials)[0] <= share <= wilson_interval(k, trials)[1]
    )
    assert 0.93 < coverage < 0.97
