import json
import os
import pickle
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from singulate.checkpoints import FileEntry, Manifest, read_checkpoint, verify_checkpoint
from singulate.exceptions import CheckpointError


def truncate(path: Path) -> None:
    weights = path / "weights.safetensors"
    weights.write_bytes(weights.read_bytes()[:-1])


def lengthen(path: Path) -> None:
    with (path / "weights.safetensors").open("ab") as file:
        file.write(b"\0")


def flip_a_bit(path: Path) -> None:
    weights = path / "weights.safetensors"
    data = bytearray(weights.read_bytes())
    data[-1] ^= 1
    weights.write_bytes(data)


def remove_weights(path: Path) -> None:
    (path / "weights.safetensors").unlink()


def remove_manifest(path: Path) -> None:
    (path / "manifest.json").unlink()


def edit_manifest(path: Path) -> None:
    manifest = path / "manifest.json"
    manifest.write_text(manifest.read_text().replace("random-2", "random-3"))


def cut_manifest(path: Path) -> None:
    manifest = path / "manifest.json"
    manifest.write_bytes(manifest.read_bytes()[:100])


def huge_manifest(path: Path) -> None:
    (path / "manifest.json").write_bytes(b" " * (2 << 20))


def deep_manifest(path: Path) -> None:
    (path / "manifest.json").write_bytes(b"[" * 100_000)


def binary_manifest(path: Path) -> None:
    (path / "manifest.json").write_bytes(b"\xff\xfe\x00")


def foreign_manifest(path: Path) -> None:
    (path / "manifest.json").write_text('{"name": "an app", "version": 3}')


def newer_manifest(path: Path) -> None:
    content = json.loads((path / "manifest.json").read_text())
    (path / "manifest.json").write_text(json.dumps({**content, "format_version": 99}))


def overflow_in_manifest(path: Path) -> None:
    content = json.loads((path / "manifest.json").read_text())
    text = json.dumps({**content, "step": "STEP"}).replace('"STEP"', "1e999")
    (path / "manifest.json").write_text(text)


def change_extra_file(path: Path) -> None:
    (path / "training_state.json").write_text('{"num_updates": 9}')


def pipe_for_weights(path: Path) -> None:
    (path / "weights.safetensors").unlink()
    os.mkfifo(path / "weights.safetensors")


def directory_for_weights(path: Path) -> None:
    (path / "weights.safetensors").unlink()
    (path / "weights.safetensors").mkdir()


DAMAGES = [
    (truncate, "bytes instead of"),
    (lengthen, "bytes instead of"),
    (flip_a_bit, "damaged or changed"),
    (remove_weights, "cannot be read"),
    (remove_manifest, "not a singulate checkpoint"),
    (edit_manifest, "damaged or changed"),
    (cut_manifest, "not valid JSON"),
    (huge_manifest, "more than the"),
    (deep_manifest, "not valid JSON"),
    (binary_manifest, "not valid JSON"),
    (foreign_manifest, "not the manifest of a singulate checkpoint"),
    (newer_manifest, "format version 99 is unknown; known: 1"),
    (overflow_in_manifest, "damaged or changed"),
    (change_extra_file, "training_state.json: damaged or changed"),
    (pipe_for_weights, "bytes instead of|not a regular file"),
    (directory_for_weights, "cannot be read|not a regular file"),
]


@pytest.mark.parametrize(("damage", "message"), DAMAGES, ids=lambda v: getattr(v, "__name__", ""))
@pytest.mark.parametrize("read", [read_checkpoint, verify_checkpoint])
def test_damage_is_found_and_said_in_one_line(
    save, read: Callable[[Path], object], damage: Callable[[Path], None], message: str
) -> None:
    path = save()
    read(path)
    damage(path)
    with pytest.raises(CheckpointError, match=message) as caught:
        read(path)
    assert "\n" not in str(caught.value)
    assert str(path) in str(caught.value)


def test_missing_directory(tmp_path: Path) -> None:
    with pytest.raises(CheckpointError, match="no such checkpoint directory"):
        read_checkpoint(tmp_path / "nowhere")


def test_a_plain_file_is_no_checkpoint(tmp_path: Path) -> None:
    (tmp_path / "model.zip").write_bytes(b"PK")
    with pytest.raises(CheckpointError, match="not a singulate checkpoint, which is a directory"):
        read_checkpoint(tmp_path / "model.zip")


def put_weights(path: Path, data: bytes) -> None:
    """Replace the weights as a tamperer would who also mends the hashes."""
    (path / "weights.safetensors").write_bytes(data)
    (path / "manifest.json").write_bytes(
        Manifest("dqn", {}, {}, 1, files={"weights.safetensors": FileEntry.of(data)}).to_bytes()
    )


class Bomb:
    def __reduce__(self) -> tuple[object, tuple[str]]:
        return os.system, ("echo should never run > exploded",)


def test_a_pickle_is_never_run(save, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    path = save()
    put_weights(path, pickle.dumps(Bomb()))
    with pytest.raises(CheckpointError, match="not valid safetensors"):
        read_checkpoint(path)
    assert not (tmp_path / "exploded").exists()


@pytest.mark.parametrize("data", [b"", b"\xff" * 64, (2**40).to_bytes(8, "little") + b"{}"])
def test_weights_that_are_no_safetensors(save, data: bytes) -> None:
    path = save()
    put_weights(path, data)
    with pytest.raises(CheckpointError, match="not valid safetensors"):
        read_checkpoint(path)


def test_weights_that_are_not_finite(save) -> None:
    path = save()
    data = (path / "weights.safetensors").read_bytes()
    one = np.float32(1.5).tobytes()
    put_weights(path, data.replace(one, np.float32(np.nan).tobytes()))
    with pytest.raises(CheckpointError, match=r"layer\.weight: holds values that are not finite"):
        read_checkpoint(path)


@pytest.mark.parametrize("name", ["../secret", "/etc/passwd", "a/b", "..", "manifest.json"])
def test_a_manifest_cannot_point_outside(save, name: str) -> None:
    path = save()
    entries = {
        "weights.safetensors": FileEntry.of((path / "weights.safetensors").read_bytes()),
        name: FileEntry.of(b""),
    }
    (path / "manifest.json").write_bytes(Manifest("dqn", {}, {}, 1, files=entries).to_bytes())
    with pytest.raises(CheckpointError, match="is not allowed"):
        read_checkpoint(path)


@pytest.mark.parametrize(
    "manifest",
    [
        Manifest(7, {}, {}, 1),  # type: ignore[arg-type]
        Manifest("dqn", [], {}, 1),  # type: ignore[arg-type]
        Manifest("dqn", {}, {}, True),
        Manifest("dqn", {}, {}, -1),
        Manifest("dqn", {}, {}, 1.5),  # type: ignore[arg-type]
        Manifest("dqn", {}, {}, 1, files={}),
        Manifest("dqn", {}, {}, 1, files={"weights.safetensors": FileEntry(-1, "")}),
    ],
)
def test_wrong_types_in_a_manifest(save, manifest: Manifest) -> None:
    path = save()
    (path / "manifest.json").write_bytes(manifest.to_bytes())
    with pytest.raises(CheckpointError) as caught:
        read_checkpoint(path)
    assert "\n" not in str(caught.value)


def test_weights_alone(save) -> None:
    path = save()
    change_extra_file(path)
    assert read_checkpoint(path, with_files=False).files == {}
