from singulate.bench import BENCHMARKS, BenchOptions


def test_both_agents_are_timed_and_the_parts_add_up() -> None:
    found = {m.name: m for m in BENCHMARKS["learning"](BenchOptions(seconds=0.1))}
    for agent, scenario in (("DQN", "random-2"), ("PPO", "fixed-2")):
        learning = found[f"{agent}, learning"]
        assert learning.unit == "pushes/s"
        assert scenario in learning.note
        parts = [found[f"{agent}, {part}"].value for part in ("environment", "acting", "update")]
        assert min(parts) > 0.0
        assert abs(sum(parts) - 1e3 / learning.value) < 1e-6
        assert 50.0 < found[f"{agent}, peak memory"].value < 4096.0
