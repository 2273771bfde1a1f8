import time
from pathlib import Path

from singulate.checkpoints import (
    checkpoint_name,
    latest_checkpoint,
    list_checkpoints,
    prune,
)


def test_names_sort_by_step(save, tmp_path: Path) -> None:
    for step in (2000, 100, 10**10):
        save(checkpoint_name(step), step)
    (tmp_path / "notes").mkdir()
    steps = [int(path.name.removeprefix("step-")) for path in list_checkpoints(tmp_path)]
    assert steps == [100, 2000, 10**10]


def test_nothing_there(tmp_path: Path) -> None:
    assert list_checkpoints(tmp_path / "missing") == []
    assert latest_checkpoint(tmp_path / "missing") is None
    assert latest_checkpoint(tmp_path) is None


def test_a_damaged_newest_one_is_passed_over_and_seen_again_when_mended(
    save, tmp_path: Path
) -> None:
    old, new = save(checkpoint_name(1), 1), save(checkpoint_name(2), 2)
    assert latest_checkpoint(tmp_path) == new
    weights = new / "weights.safetensors"
    whole = weights.read_bytes()
    weights.write_bytes(whole[:-1] + b"\7")
    assert latest_checkpoint(tmp_path) == old
    time.sleep(0.02)  # beyond the resolution of the file system's clock
    weights.write_bytes(whole)
    assert latest_checkpoint(tmp_path) == new


def test_prune_keeps_the_newest_and_one_that_verifies(save, tmp_path: Path) -> None:
    paths = [save(checkpoint_name(step), step) for step in (1, 2, 3, 4)]
    for path in paths[2:]:
        (path / "weights.safetensors").unlink()
    assert prune(tmp_path, 1) == [paths[0], paths[2]]
    assert list_checkpoints(tmp_path) == [paths[1], paths[3]]
