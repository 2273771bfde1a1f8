"""Builds a data set on an engine, shard by shard."""

import functools
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from singulate.checkpoints.durable import replace_file
from singulate.datasets.manifest import (
    MANIFEST_NAME,
    DatasetConfig,
    Manifest,
    ShardEntry,
    read_manifest,
    shard_name,
)
from singulate.datasets.scene_record import SceneRecord, SceneTask, record_scene
from singulate.datasets.shard import encode_shard, is_intact
from singulate.engine import Engine
from singulate.exceptions import InvalidValueError
from singulate.rewardmap.prober import Prober


def plan_dataset(config: DatasetConfig, directory: Path) -> tuple[Manifest, list[str]]:
    """What of a data set is there already.

    A smaller data set of the same kind may grow; its full shards are kept.

    Args:
        config: What it shall hold.
        directory: Where it lies, or nothing yet.

    Returns:
        The manifest with the shards that are intact, and the names of the damaged ones.

    Raises:
        InvalidValueError: If another data set is there, or files without a manifest.
        DatasetError: If its manifest is damaged.
    """
    if not (directory / MANIFEST_NAME).exists():
        if any(directory.glob("[!.]*")):
            allowed = f"a new or empty directory, or a data set; there is no {MANIFEST_NAME}"
            raise InvalidValueError("out", str(directory), allowed)
        return Manifest(config), []
    found = read_manifest(directory)
    is_same_kind = replace(found.config, num_scenes=config.num_scenes) == config
    if not is_same_kind or found.config.num_scenes > config.num_scenes:
        allowed = f"a directory without another data set; there is {found.config}"
        raise InvalidValueError("out", str(directory), allowed)
    intact: dict[int, ShardEntry] = {}
    damaged = []
    for number, entry in found.shards.items():
        if not is_intact(directory / shard_name(number), entry):
            damaged.append(shard_name(number))
        elif entry.num_scenes == len(config.scenes_of(number)):
            intact[number] = entry
    return Manifest(config, intact), damaged


def build_dataset(
    manifest: Manifest,
    directory: Path,
    engine: Engine,
    on_progress: Callable[[int], None] | None = None,
) -> Manifest:
    """Compute the shards that are missing.

    The files are the same bytes for any engine and any number of workers. It may be interrupted or
    killed at any time: every shard that the manifest lists is whole.

    Args:
        manifest: See `plan_dataset`.
        directory: Where it lies.
        engine: Where pushes are simulated, one scene a task.
        on_progress: Called with the number of finished scenes.

    Returns:
        The complete manifest.

    Raises:
        EngineError: If a scene failed or workers cannot be started.
        OSError: If a shard cannot be written.
    """
    config = manifest.config
    missing = [n for n in range(config.num_shards) if n not in manifest.shards]
    tasks = [SceneTask(config, index) for n in missing for index in config.scenes_of(n)]
    num_done = config.num_scenes - len(tasks)
    manifest.write(directory)
    batch = engine.submit(record_scene, tasks, functools.partial(Prober, config.goal_separation))
    waiting: dict[int, dict[int, SceneRecord]] = {}
    try:
        for result in batch:
            index = tasks[result.index].number
            shard = index // config.shard_size
            records = waiting.setdefault(shard, {})
            records[index] = result.value
            if len(records) == len(config.scenes_of(shard)):
                entry = _write_shard(directory, shard, waiting.pop(shard))
                manifest = Manifest(config, {**manifest.shards, shard: entry})
                manifest.write(directory)
            num_done += 1
            if on_progress is not None:
                on_progress(num_done)
    finally:
        batch.cancel()
    return manifest


def _write_shard(directory: Path, number: int, records: dict[int, SceneRecord]) -> ShardEntry:
    data = encode_shard([records[index] for index in sorted(records)])
    replace_file(directory / shard_name(number), data)
    return ShardEntry.of(len(records), data)
