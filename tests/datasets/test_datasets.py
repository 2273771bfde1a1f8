import json
import os
import pickle
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from torch.utils.data import DataLoader

from singulate.cli import main
from singulate.datasets import DatasetConfig, DatasetError, RecordedScenes
from singulate.datasets.building import build_dataset, plan_dataset
from singulate.datasets.torch_scenes import TorchScenes
from singulate.engine import Engine
from singulate.envs import PushEnv, scene_seed
from singulate.geometry import standing_pose
from singulate.outcomes import OUTCOMES
from singulate.rewardmap import RewardMapRequest, compute_reward_map

OPTIONS = ("dataset", "--resolution", "8", "--shard-size", "2", "--workers", "1")


def content(directory: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in directory.iterdir()}


def test_maps_are_those_of_the_rewardmap_command(dataset: Path, engine: Engine) -> None:
    scene = RecordedScenes(dataset)[3]
    env = PushEnv()
    _, info = env.reset(seed=scene_seed("dataset", 3, 3))
    env.close()
    expected = compute_reward_map(RewardMapRequest(info["poses"], resolution=10), engine)
    np.testing.assert_array_equal(scene.reward_map, expected.values.astype(np.float16))
    np.testing.assert_array_equal(scene.mask, info["mask"])
    assert scene.seed == scene_seed("dataset", 3, 3)
    is_rewarded = scene.outcomes == OUTCOMES.index("success")
    np.testing.assert_array_equal(is_rewarded, scene.reward_map > 1000.0)


def test_numpy_alone_reads_a_shard(dataset: Path) -> None:
    with np.load(dataset / "shard-000002.npz", allow_pickle=False) as arrays:
        assert {name: arrays[name].shape for name in arrays.files} == {
            "seeds": (1,),
            "blocks": (1, 2, 4),
            "masks": (1, 64, 64),
            "reward_maps": (1, 4, 10, 10),
            "outcomes": (1, 4, 10, 10),
        }


def test_scenes_of_a_mix_keep_their_numbers_of_blocks(tmp_path: Path, engine: Engine) -> None:
    config = DatasetConfig("random-2+random-3", num_scenes=8, resolution=4, shard_size=8)
    build_dataset(plan_dataset(config, tmp_path)[0], tmp_path, engine)
    scenes = RecordedScenes(str(tmp_path))
    layouts = [scenes[number].layout for number in range(len(scenes))]
    assert {len(layout) for layout in layouts} == {2, 3}
    env = PushEnv(scenario=config.scenario)
    for number, layout in enumerate(layouts):
        _, info = env.reset(seed=scene_seed("dataset", config.seed, number))
        assert tuple(map(standing_pose, layout)) == info["poses"]
    env.close()


def test_pytorch_loads_batches(dataset: Path) -> None:
    scenes = pickle.loads(pickle.dumps(TorchScenes(dataset)))  # as a loader's worker gets it
    first, second = list(DataLoader(scenes, batch_size=3))
    assert first["distance_map"].shape == (3, 64, 64)
    assert second["reward_map"].shape == (2, 4, 10, 10)
    assert bool(((first["distance_map"] < 0) == first["mask"]).all())


def test_a_lost_or_damaged_shard_is_named_and_built_again(
    tmp_path: Path, engine: Engine, dataset: Path
) -> None:
    shutil.copytree(dataset, tmp_path, dirs_exist_ok=True)
    shard = tmp_path / "shard-000001.npz"
    damaged = bytearray(shard.read_bytes())
    damaged[len(damaged) // 2] ^= 1
    shard.write_bytes(damaged)
    assert RecordedScenes(tmp_path)[0].reward_map.shape == (4, 10, 10)
    with pytest.raises(DatasetError, match=r"shard-000001\.npz: damaged"):
        RecordedScenes(tmp_path)[2]
    (tmp_path / "shard-000002.npz").unlink()
    manifest, names = plan_dataset(RecordedScenes(dataset).manifest.config, tmp_path)
    assert names == ["shard-000001.npz", "shard-000002.npz"]
    kept = (tmp_path / "shard-000000.npz").stat().st_mtime_ns
    build_dataset(manifest, tmp_path, engine)
    assert content(tmp_path) == content(dataset)
    assert (tmp_path / "shard-000000.npz").stat().st_mtime_ns == kept


def test_a_smaller_data_set_grows(tmp_path: Path, engine: Engine, dataset: Path) -> None:
    config = RecordedScenes(dataset).manifest.config
    for smaller in (replace(config, num_scenes=3), config):
        build_dataset(plan_dataset(smaller, tmp_path)[0], tmp_path, engine)
    assert content(tmp_path) == content(dataset)


@pytest.mark.parametrize("death", [signal.SIGINT, signal.SIGKILL])
def test_an_interrupted_one_keeps_whole_shards_and_goes_on(
    death: signal.Signals, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = [*OPTIONS, "--scenes", "6", "--out", str(tmp_path), "--json"]
    with subprocess.Popen([sys.executable, "-m", "singulate", *arguments]) as process:
        deadline = time.monotonic() + 60.0
        while not (tmp_path / "shard-000000.npz").exists():
            assert time.monotonic() < deadline and process.poll() is None
            time.sleep(0.005)
        os.kill(process.pid, death)
        assert process.wait(timeout=30) == (130 if death == signal.SIGINT else -death)
    with pytest.raises(DatasetError, match="incomplete"):
        RecordedScenes(tmp_path)
    assert main(arguments) == 0
    result = json.loads(capsys.readouterr().out)
    assert result["damaged"] == []
    assert len(RecordedScenes(tmp_path)) == 6
    assert {scene.reward_map.shape for scene in RecordedScenes(tmp_path)} == {(4, 8, 8)}


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (["--scenes", "0"], "num_scenes: 0 is not allowed"),
        (["--scenario", "random-99"], "scenario: 'random-99'"),
        (["--resolution", "1000"], "resolution: 1000"),
        (["--reward", "start_then_separation"], "a reward without a schedule"),
        (["--seed", "-1"], "seed: -1"),
        (["--out", "/proc/dataset"], "out: '/proc/dataset' is not allowed"),
        (["--scenario", "random-3"], "a directory without another data set"),
        (["--scenes", "4"], "a directory without another data set"),
    ],
)
def test_bad_options_are_one_line(
    options: list[str], text: str, dataset: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    same = ["--scenes", "5", "--resolution", "10", "--shard-size", "2", "--seed", "3"]
    before = content(dataset)
    assert main(["dataset", *same, "--out", str(dataset), *options]) == 2
    error = capsys.readouterr().err
    assert text in error
    assert error.count("\n") == 1
    assert content(dataset) == before


def test_a_damaged_manifest_is_named(
    tmp_path: Path, dataset: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (dataset / "dataset.json").read_text()
    (tmp_path / "dataset.json").write_text(text.replace('"seed": 3', '"seed": 4'))
    assert main(["dataset", "--out", str(tmp_path)]) == 2
    assert "dataset.json: damaged" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("manifest", "text"),
    [
        ("{}", "damaged (format is missing)"),
        ("[]", "damaged (a value of another type is expected)"),
        ("{", "damaged (Expecting property name"),
        (
            '{"format": "singulate-reward-maps", "format_version": 9}',
            "of another format; allowed: version 1",
        ),
    ],
)
def test_what_is_wrong_with_a_manifest_is_told(manifest: str, text: str, tmp_path: Path) -> None:
    (tmp_path / "dataset.json").write_text(manifest)
    with pytest.raises(DatasetError) as caught:
        RecordedScenes(tmp_path)
    assert text in str(caught.value)


def test_a_directory_with_other_files_is_refused_and_left_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "thesis.txt").write_text("mine")
    assert main(["dataset", "--scenes", "1", "--out", str(tmp_path)]) == 2
    error = capsys.readouterr().err
    assert "a new or empty directory" in error
    assert error.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.txt"]
