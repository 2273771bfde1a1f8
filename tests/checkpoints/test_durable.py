import os
import subprocess
import sys
from pathlib import Path

import pytest

from singulate.checkpoints.durable import replace_file


def test_what_cannot_be_replaced_is_named_and_left(tmp_path: Path) -> None:
    target = tmp_path / "results"
    target.mkdir()
    with pytest.raises(IsADirectoryError) as caught:
        replace_file(target, b"new")
    assert caught.value.filename == str(target)
    assert os.listdir(tmp_path) == ["results"]


FULL_DISK = """
import resource, sys
from pathlib import Path
from singulate.checkpoints.durable import replace_file
resource.setrlimit(resource.RLIMIT_FSIZE, (1_000, resource.getrlimit(resource.RLIMIT_FSIZE)[1]))
try:
    replace_file(Path(sys.argv[1]), bytes(10_000))
except OSError as error:
    print(f"{error.filename}: {error.strerror}")
"""


def test_a_full_disk_is_told_by_the_file_that_does_not_fit(tmp_path: Path) -> None:
    path = tmp_path / "results"
    command = [sys.executable, "-c", FULL_DISK, str(path)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.stdout == f"{path}: File too large\n", done.stderr
    assert os.listdir(tmp_path) == []
