import shutil
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path

import numpy as np

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.loading import load_policy
from singulate.checkpoints import read_checkpoint
from singulate.engine import LocalEngine
from singulate.envs import EnvConfig
from singulate.experiments.cell import Cell, run_cell
from singulate.experiments.cell_store import CellStore
from singulate.experiments.figures import autoencoder
from singulate.experiments.figures.paper_figure import Sources
from singulate.experiments.figures.plan import Plan
from singulate.experiments.figures.published import Published
from singulate.experiments.figures.variants import VARIANTS
from singulate.experiments.shared_autoencoder import ensure_autoencoder
from singulate.runs import RunDirectory
from singulate.training.config import TrainingConfig

SMALL = AutoencoderConfig("random-2", num_scenes=8, num_updates=4, batch_size=4)
TRAINING = TrainingConfig(
    "dqn",
    EnvConfig("random-2", action="grid"),
    30,
    agent_config={"learning_starts": 10, "batch_size": 4, "net_arch": [8]},
)
CELL = Cell(TRAINING, episodes=2, autoencoder=SMALL)


def test_it_is_trained_by_one_of_those_who_need_it(tmp_path: Path) -> None:
    directory = tmp_path / "cells" / "ae"
    context = get_context("spawn")
    others = [context.Process(target=ensure_autoencoder, args=(SMALL, directory)) for _ in range(2)]
    for process in others:
        process.start()
    for process in others:
        process.join()
        assert process.exitcode == 0
    before = (directory / "manifest.json").stat().st_mtime_ns
    assert ensure_autoencoder(SMALL, directory) == directory
    assert (directory / "manifest.json").stat().st_mtime_ns == before


def test_a_damaged_one_is_trained_anew(tmp_path: Path) -> None:
    directory = ensure_autoencoder(SMALL, tmp_path / "ae")
    weights = directory / "weights.safetensors"
    whole = weights.read_bytes()
    weights.write_bytes(whole[:100])
    ensure_autoencoder(SMALL, directory)
    assert weights.read_bytes() == whole


def test_a_cell_trains_what_it_looks_through_and_its_agent_needs_it_no_more(
    tmp_path: Path,
) -> None:
    store = CellStore(tmp_path)
    result = run_cell(object(), store.task(CELL))
    assert (result.num_steps, result.num_episodes) == (30, 2)
    encoder = read_checkpoint(store.autoencoder_dir(SMALL)).tensors["encoder.code.weight"]
    newest = RunDirectory(store.run_dir(CELL)).latest_checkpoint()
    assert newest is not None
    seen = read_checkpoint(newest).tensors["features_extractor.encoder.code.weight"]
    assert (seen == encoder).all()
    shutil.rmtree(store.autoencoder_dir(SMALL))
    assert load_policy(newest).kind == "dqn"


def test_the_recipe_decides_the_key_and_no_place_does(tmp_path: Path) -> None:
    plain = replace(CELL, autoencoder=None)
    other = replace(CELL, autoencoder=replace(SMALL, seed=1))
    assert len({plain.key, CELL.key, other.key}) == 3
    assert CellStore(tmp_path).task(plain).autoencoder_dir is None
    directory = CellStore(tmp_path).task(CELL).autoencoder_dir
    assert directory is not None and Path(directory).parent == tmp_path


def test_the_figure_shows_unseen_scenes_and_what_is_left_of_them(tmp_path: Path) -> None:
    plan = Plan((0,), autoencoder=SMALL)
    cells = [cell for name in autoencoder.VARIANTS for cell in VARIANTS[name].cells(plan)]
    summaries = {cell.key: {"seed": cell.training.seed} for cell in cells}
    with LocalEngine(1) as engine:
        sources = Sources(plan, CellStore(tmp_path), engine, Published(summaries))
        data = autoencoder.measure(sources)
        assert autoencoder.measure(replace(sources, published=Published())) is None
    assert data is not None
    assert data["quality"]["num_scenes"] == 1000
    assert [scene["scenario"] for scene in data["scenes"]] == list(autoencoder.SCENARIOS)
    for scene in data["scenes"]:
        shown, made = (np.array(scene[key]) for key in ("map_px", "reconstruction_px"))
        assert shown.shape == made.shape == (64, 64)
        assert shown.min() == -1.0
        assert not np.array_equal(shown, made)
    assert set(data["runs"]) == set(autoencoder.VARIANTS)
