"""Computes the cells of an experiment that are not there yet, on any engine."""

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass

from singulate.engine import Engine
from singulate.experiments.cell import Cell, CellResult, run_cell
from singulate.experiments.cell_store import CellStore

POLL_S = 0.5


@dataclass(frozen=True)
class Outcome:
    """What is known of the cells of an experiment.

    Attributes:
        results: Finished cells in their order.
        failures: Why others have failed, one line each, by name.
        num_computed: How many of the finished ones were computed now.
    """

    results: list[tuple[Cell, CellResult]]
    failures: dict[str, str]
    num_computed: int


@dataclass(frozen=True)
class CellProgress:
    """How far an experiment is.

    Attributes:
        num_steps: Pushes of all trainings so far.
        num_finished: Cells that are finished or have failed.
    """

    num_steps: int
    num_finished: int


def run_cells(
    cells: Sequence[Cell],
    store: CellStore,
    open_engine: Callable[[], AbstractContextManager[Engine]],
    on_progress: Callable[[CellProgress], None] | None = None,
) -> Outcome:
    """Compute what is missing; a cell that fails does not keep the others from finishing.

    It may be killed at any time: finished cells stay, and the trainings of others go on from their
    last checkpoints the next time. Results do not depend on the engine.

    Args:
        cells: The cells; equal ones are computed once.
        store: Where they lie. On a cluster without a shared file system, an interrupted cell that
            goes on at another node starts anew there.
        open_engine: Called if something is missing; the engine is left at the end.
        on_progress: Called now and then.

    Raises:
        EngineError: If workers cannot be started.
        OSError: If a result cannot be written.
    """
    unique = list({cell.key: cell for cell in cells}.values())
    found = {cell.name: store.read(cell) for cell in unique}
    missing = [cell for cell in unique if found[cell.name] is None]
    failures: dict[str, str] = {}
    if missing:
        with open_engine() as engine:
            tasks = [store.task(cell) for cell in missing]
            batch = engine.submit(run_cell, tasks, object)
            while not batch.is_done:
                finished = batch.poll(POLL_S)
                if finished is not None:
                    cell = missing[finished.index]
                    if finished.error is not None:
                        failures[cell.name] = finished.error
                    else:
                        store.write(cell, finished.value)
                        found[cell.name] = finished.value
                if on_progress is not None:
                    open_cells = [each for each in unique if found[each.name] is None]
                    on_progress(_progress(unique, open_cells, failures, store))
    results = [(cell, result) for cell in unique if (result := found[cell.name]) is not None]
    return Outcome(results, failures, len(missing) - len(failures))


def _progress(
    cells: list[Cell], open_cells: list[Cell], failures: dict[str, str], store: CellStore
) -> CellProgress:
    running = [cell for cell in open_cells if cell.name not in failures]
    num_left = sum(cell.training.total_timesteps - store.num_steps(cell) for cell in running)
    num_steps = sum(cell.training.total_timesteps for cell in cells) - num_left
    return CellProgress(num_steps, len(cells) - len(running))
