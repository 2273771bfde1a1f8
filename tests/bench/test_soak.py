"""A small soak; the long one is committed in docs/memory.json."""

import json
from pathlib import Path

import psutil
import pytest

from singulate.bench.memory import own_memory, workers_memory
from singulate.bench.soak import SoakOptions, SoakResults, read_soak, soak
from singulate.cli import main
from singulate.engine import LocalEngine

MAX_GROWTH_MIB = 8.0


def check_flat(results: SoakResults) -> None:
    for memory in (results.pushes, results.reward_maps):
        assert len(memory.worker_mib) == len(memory.parent_mib) == len(memory.num_done) == 10
        assert memory.growth_mib == pytest.approx(memory.worker_mib[-1] - memory.worker_mib[0])
        assert memory.growth_mib < MAX_GROWTH_MIB, memory
        assert memory.parent_mib[-1] - memory.parent_mib[0] < MAX_GROWTH_MIB, memory


def test_memory_is_flat_over_some_pushes_and_maps() -> None:
    counted = {"pushes": 0, "maps": 0}

    def count(what: str, more: int) -> None:
        counted[what] += more

    results = soak(
        SoakOptions(num_pushes=500, num_maps=10, hit_share=0.1, resolution=8),
        on_push=lambda more: count("pushes", more),
        on_map=lambda more: count("maps", more),
    )
    assert counted == {"pushes": 500, "maps": 10}
    assert results.pushes.num_done == list(range(50, 501, 50))
    check_flat(results)


@pytest.mark.slow
@pytest.mark.timeout(7200)
def test_memory_is_flat_over_100_000_pushes_and_1000_maps() -> None:
    check_flat(soak(SoakOptions()))


def test_memory_is_what_the_operating_system_says() -> None:
    mine = own_memory()
    assert mine.resident_bytes == pytest.approx(psutil.Process().memory_info().rss, rel=0.05)
    assert mine.peak_bytes >= mine.resident_bytes
    with LocalEngine(2) as engine:
        workers = workers_memory(engine)
        assert [each.pid for each in workers] == sorted(engine.pids)
        resident = psutil.Process(workers[0].pid).memory_info().rss
        assert workers[0].resident_bytes == pytest.approx(resident, rel=0.1)


def test_the_command_writes_its_report(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "memory.json"
    sizes = ["--pushes", "10", "--maps", "10", "--resolution", "2", "--hits", "1"]
    assert main(["soak", *sizes, "--json", "--out", str(out)]) == 0
    assert json.loads(out.read_text()) == json.loads(capsys.readouterr().out)
    assert read_soak(out).pushes.num_done == list(range(1, 11))


@pytest.mark.parametrize(
    ("option", "value"), [("pushes", "9"), ("maps", "0"), ("hits", "1.5"), ("resolution", "0")]
)
def test_numbers_out_of_range_are_refused(
    option: str, value: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["soak", f"--{option}", value]) == 2
    assert f"{option}: " in capsys.readouterr().err
