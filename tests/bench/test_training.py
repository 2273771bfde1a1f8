from collections.abc import Iterator
from dataclasses import replace

import pytest

from singulate.bench import BENCHMARKS, BenchOptions, Measurement
from singulate.bench.training import CONFIGS

LOCAL_PARTS = ("physics", "image", "perception", "rest of the environment", "update", "acting")
WORKER_PARTS = ("waiting", "update", "acting")


@pytest.fixture(scope="module")
def found() -> Iterator[dict[str, Measurement]]:
    """Of shorter trainings in fewer ways than outside of tests."""
    changes = ({"learning_starts": 20}, {"n_steps": 32})
    pairs = zip(CONFIGS, changes, strict=True)
    with pytest.MonkeyPatch.context() as patch:
        short = [replace(config, agent_config=change) for config, change in pairs]
        patch.setattr("singulate.bench.training.CONFIGS", short)
        patch.setattr("singulate.bench.training.WAYS", ((1, 0, 1), (4, 2, 2)))
        options = BenchOptions(seconds=0.1, num_repeats=1)
        yield {m.name: m for m in BENCHMARKS["training"](options)}


@pytest.mark.parametrize(("agent", "scenario"), [("DQN", "random-2"), ("PPO", "fixed-2")])
@pytest.mark.parametrize(
    ("way", "parts"),
    [
        ("1 environment", LOCAL_PARTS),
        ("4 environments, 2 workers, 2 threads", WORKER_PARTS),
    ],
)
def test_both_agents_are_timed_and_the_parts_add_up(
    agent: str, scenario: str, way: str, parts: tuple[str, ...], found: dict[str, Measurement]
) -> None:
    learning = found[f"{agent}, {way}"]
    assert learning.unit == "pushes/s"
    assert scenario in learning.note
    spent = [found[f"{agent}, {way}, {part}"].value for part in parts]
    assert min(spent) > 0.0
    assert abs(sum(spent) - 1e3 / learning.value) < 1e-6
    assert 50.0 < found[f"{agent}, {way}, peak memory"].value < 4096.0
    assert found[f"{agent}, {way}, cores"].value > 0.1


@pytest.mark.parametrize("agent", ["DQN", "PPO"])
def test_gains_are_ratios_of_the_same_run(agent: str, found: dict[str, Measurement]) -> None:
    way = f"{agent}, 4 environments, 2 workers, 2 threads"
    expected = found[way].value / found[f"{agent}, 1 environment"].value
    assert found[f"{way}, gain"].value == pytest.approx(expected)


def test_a_gradient_step_is_compared_with_that_of_stable_baselines3(
    found: dict[str, Measurement],
) -> None:
    step = "DQN, gradient step"
    gain = found[f"{step}, stable-baselines3"].value / found[step].value
    assert found[f"{step}, gain"].value == pytest.approx(gain)
