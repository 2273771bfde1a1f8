"""A small data set, built once."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from singulate.datasets import DatasetConfig
from singulate.datasets.building import build_dataset, plan_dataset
from singulate.engine import Engine, LocalEngine

CONFIG = DatasetConfig(num_scenes=5, resolution=10, shard_size=2, seed=3)


@pytest.fixture(scope="session")
def engine() -> Iterator[Engine]:
    with LocalEngine(num_workers=2, niceness=0) as engine:
        yield engine


@pytest.fixture(scope="session")
def dataset(tmp_path_factory: pytest.TempPathFactory, engine: Engine) -> Path:
    directory = tmp_path_factory.mktemp("dataset")
    build_dataset(plan_dataset(CONFIG, directory)[0], directory, engine)
    return directory
