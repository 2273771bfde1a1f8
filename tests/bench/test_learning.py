import math
from itertools import pairwise

import pytest

from singulate.bench import BenchOptions, learning, learning_curve
from singulate.bench.learning_curve import LearningCurve, Look
from singulate.envs import EnvConfig
from singulate.training.config import TrainingConfig

SEEDS = 3


def test_a_curve_looks_at_unseen_scenes_until_its_last_push(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(learning_curve, "NUM_SCENES", 40)
    config = TrainingConfig("dqn", EnvConfig("random-2", action="grid"), 150)
    looks = learning_curve.learning_curve(config, (0.95, 0.99)).looks
    assert [look.num_pushes for look in looks] == [100, 120, 144, 150]
    assert all(a.seconds < b.seconds for a, b in pairwise(looks))
    # An untrained agent fails at once, so the looks are broken off.
    assert all(look.success < 0.5 and look.num_scenes == 25 for look in looks)


def test_a_training_ends_at_the_highest_rate(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(learning_curve, "NUM_SCENES", 25)
    config = TrainingConfig("dqn", EnvConfig("random-2", action="grid"), 1000)
    (look,) = learning_curve.learning_curve(config, (0.0,)).looks
    assert (look.num_pushes, look.num_scenes) == (100, 25)


def _curve(*shares: float) -> LearningCurve:
    return LearningCurve([Look(100 * (i + 1), float(i), s, 500) for i, s in enumerate(shares)])


@pytest.mark.parametrize(
    ("arrivals", "expected"), [((1, 3, 2), 200.0), ((1, None, 3), 300.0), ((1, None, None), None)]
)
def test_seeds_that_do_not_arrive_come_last_in_the_median(
    arrivals: tuple[int | None, ...], expected: float | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    curves = [
        _curve(*[0.5] * 4) if at is None else _curve(*[0.5] * (at - 1), 0.96) for at in arrivals
    ]
    never = [_curve(0.2)] * SEEDS
    found = dict.fromkeys(learning.MAX_PUSHES, never) | {"ppo": curves}
    monkeypatch.setattr(learning, "_curve", lambda agent, seed: found[agent][seed])
    measured = {m.name: m for m in learning.bench_learning(BenchOptions(num_seeds=SEEDS))}
    assert measured["ppo, pushes to 95%"].value == expected
    assert measured["ppo, pushes to 99%"].value is None
    assert measured["ppo, success"].value == sorted(c.looks[-1].success for c in curves)[1]
    gain = measured["ppo, pushes to 95%, gain"]
    if expected is None:
        assert gain.value is None
    else:
        assert math.isclose(gain.value, 20_000 / expected)
        assert "at least" in gain.note
