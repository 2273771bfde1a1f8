"""What every engine must do, seen through the interface alone."""

import time
from pathlib import Path

import engine_tasks as tasks
import pytest

from singulate.engine import Engine, EngineError


def test_results_carry_the_index_of_their_task(engine: Engine) -> None:
    batch = engine.submit(tasks.square, list(range(50)), object)
    assert {r.index: r.value for r in batch} == {i: i * i for i in range(50)}
    assert batch.num_tasks == 50
    assert batch.is_done


def test_empty_batch_is_done_at_once(engine: Engine) -> None:
    batch = engine.submit(tasks.square, [], object)
    assert batch.is_done
    assert list(batch) == []


def test_results_come_as_tasks_finish(engine: Engine) -> None:
    batch = engine.submit(tasks.sleep, [1.0, 0.0], object)
    assert [r.index for r in batch] == [1, 0]


def test_poll_gives_up_after_its_timeout(engine: Engine, pace: float) -> None:
    batch = engine.submit(tasks.sleep, [5.0], object)
    began = time.monotonic()
    assert batch.poll(timeout_s=0.05) is None
    assert time.monotonic() - began < 1.0 * pace
    assert not batch.is_done


def test_a_tool_is_built_once_a_worker_and_kept(engine: Engine) -> None:
    results = [r.value for r in engine.submit(tasks.uses_of_tool, [0.01] * 20, tasks.Counter)]
    results += [r.value for r in engine.submit(tasks.uses_of_tool, [0.01] * 20, tasks.Counter)]
    pids = {pid for pid, _ in results}
    assert 1 <= len(pids) <= engine.num_workers
    for pid in pids:
        uses = sorted(count for each, count in results if each == pid)
        assert uses == list(range(1, len(uses) + 1))


def test_an_exception_is_reported_in_one_line_and_not_retried(engine: Engine) -> None:
    (result,) = engine.submit(tasks.fail, [7], object)
    assert result.error == "ValueError: 7 is odd and this is a second line"
    assert result.num_attempts == 1
    with pytest.raises(EngineError, match="7 is odd"):
        _ = result.value


def test_a_task_whose_worker_dies_is_retried(engine: Engine, tmp_path: Path) -> None:
    (result,) = engine.submit(tasks.die_once, [str(tmp_path / "died")], object)
    assert result.value == "survived"
    assert result.num_attempts == 2


def test_a_task_that_kills_two_workers_is_reported_and_others_finish(engine: Engine) -> None:
    deadly = engine.submit(tasks.die, [0, 1], object)
    harmless = engine.submit(tasks.square, list(range(20)), object)
    assert sum(r.value for r in harmless) == sum(i * i for i in range(20))
    results = list(deadly)
    assert sorted(r.index for r in results) == [0, 1]
    assert all(r.error is not None and "2 workers died" in r.error for r in results)


def test_cancel_drops_what_has_not_begun(engine: Engine, tmp_path: Path, pace: float) -> None:
    marks = [(str(tmp_path / str(i)), 0.02) for i in range(100)]
    batch = engine.submit(tasks.mark_and_sleep, marks, object)
    assert batch.poll(timeout_s=20.0) is not None
    began = time.monotonic()
    batch.cancel()
    assert time.monotonic() - began < 0.05 * pace
    assert batch.is_done
    assert list(batch) == []
    time.sleep(1.5)  # enough for all of them
    assert len(list(tmp_path.iterdir())) < 20


def test_after_a_cancel_the_next_batch_waits_for_running_tasks_only(
    engine: Engine, pace: float
) -> None:
    list(engine.submit(tasks.square, [1], object))
    batch = engine.submit(tasks.sleep, [0.02] * 200, object)
    assert batch.poll(timeout_s=20.0) is not None
    batch.cancel()
    began = time.monotonic()
    assert next(iter(engine.submit(tasks.square, [3], object))).value == 9
    assert time.monotonic() - began < 0.5 * pace


def test_a_short_batch_is_not_held_up_by_a_long_one(engine: Engine) -> None:
    long = engine.submit(tasks.sleep, [0.05] * 100, object)
    short = engine.submit(tasks.square, [2, 3], object)
    assert sorted(r.value for r in short) == [4, 9]
    assert not long.is_done
    long.cancel()


def test_large_tasks_and_results_pass(engine: Engine) -> None:
    blob = bytes(range(256)) * 8192  # 2 MiB
    assert all(r.value == blob[::-1] for r in engine.submit(tasks.big, [blob] * 6, object))


def test_a_closed_engine_says_so(engine: Engine, pace: float) -> None:
    batch = engine.submit(tasks.sleep, [30.0], object)
    began = time.monotonic()
    engine.close()
    engine.close()
    assert time.monotonic() - began < 5.0 * pace
    with pytest.raises(EngineError, match="closed"):
        batch.poll()
    with pytest.raises(EngineError, match="closed"):
        engine.submit(tasks.square, [1], object)
