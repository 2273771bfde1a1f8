import stat
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from singulate.checkpoints import Manifest, read_checkpoint, save_checkpoint
from singulate.exceptions import CheckpointError

MANIFEST = Manifest(agent="dqn", agent_config={}, env_config={}, step=1)
WEIGHTS = {"w": np.ones(2, np.float32)}


def test_what_is_saved_is_read_back(save) -> None:
    checkpoint = read_checkpoint(save())
    assert checkpoint.manifest.agent == "dqn"
    assert checkpoint.manifest.agent_config == {"learning_rate": 5e-4, "net_arch": [128, 64]}
    assert checkpoint.manifest.env_config == {"scenario": "random-2"}
    assert checkpoint.manifest.step == 100
    assert checkpoint.manifest.notes == {"seed": 0}
    assert checkpoint.files == {"training_state.json": b'{"num_updates": 3}'}
    weight = checkpoint.tensors["layer.weight"]
    assert weight.dtype == np.float32
    assert weight.flags.writeable
    np.testing.assert_array_equal(weight, np.full((4, 3), 1.5, np.float32))
    assert checkpoint.tensors["count"].shape == ()
    assert checkpoint.tensors["count"] == 100


def test_a_transposed_array_keeps_its_order(tmp_path: Path) -> None:
    array = np.arange(6, dtype=np.float32).reshape(2, 3).T
    path = save_checkpoint(tmp_path / "c", {"w": array}, MANIFEST)
    np.testing.assert_array_equal(read_checkpoint(path).tensors["w"], array)


def test_others_may_read_the_directory_as_the_umask_says(save) -> None:
    path = save()
    (path.parent / "plain").mkdir()
    assert stat.S_IMODE(path.stat().st_mode) == stat.S_IMODE((path.parent / "plain").stat().st_mode)


def test_the_readme_may_be_edited(save) -> None:
    path = save()
    (path / "README.md").write_text("success 90 %")
    assert read_checkpoint(path).manifest.step == 100


def test_saving_again_replaces(save) -> None:
    save(value=1.0)
    path = save(value=2.0)
    assert read_checkpoint(path).tensors["layer.weight"].max() == 2.0
    assert [p.name for p in path.parent.iterdir()] == [path.name]


def test_a_directory_that_is_no_checkpoint_is_not_replaced(tmp_path: Path) -> None:
    precious = tmp_path / "thesis"
    precious.mkdir()
    (precious / "chapter1.tex").write_text("x")
    with pytest.raises(CheckpointError, match="not a checkpoint"):
        save_checkpoint(precious, WEIGHTS, MANIFEST)
    assert (precious / "chapter1.tex").read_text() == "x"
    assert [p.name for p in tmp_path.iterdir()] == ["thesis"]


@pytest.mark.parametrize("manifest", ['{"name": "web app"}', "[]", "not json", ""])
def test_a_manifest_of_something_else_protects_its_directory(tmp_path: Path, manifest: str) -> None:
    precious = tmp_path / "extension"
    precious.mkdir()
    (precious / "manifest.json").write_text(manifest)
    with pytest.raises(CheckpointError, match="not a checkpoint"):
        save_checkpoint(precious, WEIGHTS, MANIFEST)
    assert (precious / "manifest.json").read_text() == manifest


def test_a_damaged_checkpoint_may_be_replaced(save) -> None:
    manifest = save() / "manifest.json"
    manifest.write_bytes(manifest.read_bytes()[:200])
    assert read_checkpoint(save()).manifest.step == 100


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_weights_that_are_not_finite_are_refused(tmp_path: Path, value: float) -> None:
    with pytest.raises(CheckpointError, match="w: holds values that are not finite"):
        save_checkpoint(tmp_path / "c", {"w": np.array([1.0, value])}, MANIFEST)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["../evil", "a/b", ".hidden", "manifest.json", "", "x" * 200])
def test_file_names_are_plain(tmp_path: Path, name: str) -> None:
    with pytest.raises(CheckpointError, match="not allowed"):
        save_checkpoint(tmp_path / "c", WEIGHTS, MANIFEST, {name: b""})
    assert list(tmp_path.iterdir()) == []


def test_objects_cannot_be_stored(tmp_path: Path) -> None:
    with pytest.raises(CheckpointError, match="cannot be stored"):
        save_checkpoint(tmp_path / "c", {"w": np.array([object()])}, MANIFEST)
    with pytest.raises(CheckpointError, match="manifest cannot be written"):
        bad = Manifest(agent="dqn", agent_config={"lr": float("nan")}, env_config={}, step=1)
        save_checkpoint(tmp_path / "c", WEIGHTS, bad)


def test_leftovers_of_a_killed_writer_are_tidied(save, tmp_path: Path) -> None:
    partial = tmp_path / ".step-000000050.0123abcd.partial"
    partial.mkdir()
    (partial / "weights.safetensors").write_bytes(b"half")
    save(name="step-000000060", step=60).rename(tmp_path / ".step-000000060.0123abcd.replaced")
    path = save()
    names = sorted(p.name for p in tmp_path.iterdir())
    assert names == ["step-000000060", path.name]
    assert read_checkpoint(tmp_path / "step-000000060").manifest.step == 60


FULL_DISK = """
import resource, sys
from pathlib import Path
import numpy as np
from singulate.checkpoints import Manifest, save_checkpoint
from singulate.exceptions import CheckpointError
parent = Path(sys.argv[1])
manifest = Manifest(agent="dqn", agent_config={}, env_config={}, step=1)
save_checkpoint(parent / "step-000000001", {"w": np.ones(10, np.float32)}, manifest)
resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, resource.getrlimit(resource.RLIMIT_FSIZE)[1]))
for name in ("step-000000001", "step-000000002"):
    try:
        save_checkpoint(parent / name, {"w": np.ones(100_000, np.float32)}, manifest)
    except CheckpointError as error:
        print(error)
"""


def test_a_full_disk_leaves_the_last_good_one_and_nothing_else(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", FULL_DISK, str(tmp_path)], capture_output=True, text=True
    )
    lines = done.stdout.splitlines()
    assert len(lines) == 2, done.stderr
    assert all("could not be saved (File too large)" in line for line in lines)
    assert [p.name for p in tmp_path.iterdir()] == ["step-000000001"]
    assert read_checkpoint(tmp_path / "step-000000001").tensors["w"].size == 10
