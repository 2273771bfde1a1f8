"""Makes the paper's figures and judges its claims, going on where it was interrupted."""

import json
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from singulate.checkpoints.durable import replace_file
from singulate.engine import Engine
from singulate.experiments.ceiling import CeilingConfig, measure_ceiling
from singulate.experiments.cell_store import CellStore
from singulate.experiments.claims.claim import Claim
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.registry import CEILING_SCENARIOS, VARIANTS, judge_all
from singulate.experiments.claims.table import write_claims
from singulate.experiments.figures.paper_figure import Data, PaperFigure, Sources
from singulate.experiments.figures.plan import Plan
from singulate.experiments.figures.published import TRAININGS_NAME
from singulate.experiments.figures.style import save_figure
from singulate.experiments.figures.summaries import summarise
from singulate.experiments.figures.variants import VARIANTS as ALL_VARIANTS
from singulate.experiments.run_cells import run_cells

CLAIMS = "claims"
"""Name of the last step, beside the figures' names."""
PAPER_GRID = 10

OnProgress = Callable[[str, int, int], None]
"""Called with the step, how much of it is done, and how much it is."""


@dataclass
class Reproduction:
    """What became of a reproduction.

    Attributes:
        written: Files, in order.
        unfinished: Figures that wait for trainings.
        failures: Why trainings have failed, by name.
        num_computed: Trainings that were finished now.
        claims: The claims, where they were asked for.
    """

    written: list[Path] = field(default_factory=list)
    unfinished: list[str] = field(default_factory=list)
    failures: dict[str, str] = field(default_factory=dict)
    num_computed: int = 0
    claims: list[Claim] = field(default_factory=list)


def reproduce(
    figures: Sequence[PaperFigure],
    sources: Sources,
    out: Path,
    *,
    with_claims: bool,
    with_training: bool = True,
    on_progress: OnProgress = lambda step, done, total: None,
) -> Reproduction:
    """Train what is missing, measure, draw and judge, one figure after another.

    Args:
        figures: Which figures.
        sources: Plan, trainings and engine.
        out: Where pictures and numbers go.
        with_claims: Whether to judge the claims too.
        with_training: Whether to train what is missing; else only what is finished is used.
        on_progress: See `OnProgress`.

    Raises:
        EngineError: If workers cannot be started.
        OSError: If something cannot be written.
    """
    made = Reproduction()
    evidence_of_figures: dict[str, Data] = {}
    for figure in figures:
        data = _published(figure, sources)
        if data is None and with_training:
            _train(figure.name, figure.variants, sources, made, on_progress)
        data = data or _with_published_seeds(figure, figure.measure(sources), sources)
        if data is None:
            made.unfinished.append(figure.name)
            continue
        evidence_of_figures[figure.name] = data
        _write_figure(figure, data, sources.plan, out, made)
    if with_claims:
        if with_training:
            _train(CLAIMS, VARIANTS, sources, made, on_progress)
        _judge(sources, evidence_of_figures, out, made, on_progress)
    return made


def _published(figure: PaperFigure, sources: Sources) -> Data | None:
    """Its numbers, if they are published together with all of its trainings."""
    cells = [cell for name in figure.variants for cell in ALL_VARIANTS[name].cells(sources.plan)]
    is_known = bool(cells) and sources.published.has(cells)
    return sources.published.figures.get(figure.name) if is_known else None


def _with_published_seeds(figure: PaperFigure, data: Data | None, sources: Sources) -> Data | None:
    """Add to what was measured of each seed what is published of seeds whose trainings are gone."""
    published = sources.published.figures.get(figure.name, {})
    cells = [cell for name in figure.variants for cell in ALL_VARIANTS[name].cells(sources.plan)]
    gone = {
        cell.training.seed
        for cell in cells
        if sources.published.has([cell]) and not sources.store.has_run(cell)
    }
    kept = [seed for seed in published.get("seeds", []) if seed["seed"] in gone]
    if not kept:
        return data
    measured = data["seeds"] if data is not None else []
    seeds = sorted([*kept, *measured], key=lambda seed: int(seed["seed"]))
    return {**(published if data is None else data), "seeds": seeds}


def _train(
    step: str,
    variants: Sequence[str],
    sources: Sources,
    made: Reproduction,
    on_progress: OnProgress,
) -> None:
    cells = [cell for name in variants for cell in ALL_VARIANTS[name].cells(sources.plan)]
    cells = [cell for cell in cells if cell.key not in sources.published.summaries]
    total = sum(cell.training.total_timesteps for cell in cells)
    outcome = run_cells(
        cells,
        sources.store,
        lambda: nullcontext(sources.engine),
        lambda progress: on_progress(step, progress.num_steps, total),
    )
    made.failures |= outcome.failures
    made.num_computed += outcome.num_computed


def _judge(
    sources: Sources,
    figures: dict[str, Data],
    out: Path,
    made: Reproduction,
    on_progress: OnProgress,
) -> None:
    plan = sources.plan
    ceilings = {
        scenario: _ceiling(scenario, plan, sources.engine, out / "ceilings.json", on_progress)
        for scenario in CEILING_SCENARIOS
    }
    evidence = Evidence(summarise(ALL_VARIANTS, sources), figures, ceilings)
    _write_json(out / TRAININGS_NAME, evidence.runs, made)
    _write_json(out / "ceilings.json", ceilings, made)
    made.claims = judge_all(evidence)
    write_claims(out, made.claims, evidence, plan)
    made.written += [out / "claims.json", out / "claims.md"]


def _ceiling(
    scenario: str, plan: Plan, engine: Engine, known_at: Path, on_progress: OnProgress
) -> dict[str, Any]:
    """The ceiling of the paper's grid, measured unless the file has the very same one."""
    config = CeilingConfig(scenario, PAPER_GRID, plan.num_scenes, plan.evaluation_seed)
    about = {"grid": config.grid, "seed": config.seed, "num_scenes": config.num_scenes}
    try:
        known: dict[str, Any] = json.loads(known_at.read_bytes())[scenario]
        if {key: known[key] for key in about} == about:
            return known
    except (OSError, ValueError, KeyError, TypeError):
        pass
    step = f"ceiling of {scenario}"
    ceiling = measure_ceiling(
        config, engine, lambda done: on_progress(step, done, config.num_scenes)
    )
    return {**about, **ceiling.to_dict()}


def _write_figure(
    figure: PaperFigure, data: Data, plan: Plan, out: Path, made: Reproduction
) -> None:
    _write_json(out / f"{figure.name}.json", data, made)
    save_figure(figure.draw(data), out / f"{figure.name}.png")
    made.written.append(out / f"{figure.name}.png")
    if figure.page is not None:
        replace_file(out / f"{figure.name}.md", figure.page(data, plan).encode())
        made.written.append(out / f"{figure.name}.md")


def _write_json(path: Path, data: Any, made: Reproduction) -> None:
    replace_file(path, (json.dumps(data, separators=(",", ":")) + "\n").encode())
    made.written.append(path)


def open_store(directory: Path) -> CellStore:
    """The trainings of reproductions in a directory."""
    return CellStore(directory / "cells")
