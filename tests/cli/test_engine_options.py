import json
import socket
import subprocess
import sys

import pytest

from singulate.cli import main

EVALUATE = ("evaluate", "random", "--episodes", "40", "--json")


def test_ray_and_local_workers_give_the_same_evaluation() -> None:
    results = []
    for options in (["--engine", "ray", "--workers", "2"], ["--workers", "1"]):
        command = [sys.executable, "-m", "singulate", *EVALUATE, *options]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120)
        assert done.returncode == 0, done.stderr
        results.append(json.loads(done.stdout))
    assert results[0] == results[1]


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (["--engine", "dask"], "engine: 'dask' is not allowed; allowed: local, ray"),
        (["--address", "auto"], "address: 'auto' is not allowed"),
        (["--workers", "0"], "num_workers: 0 is not allowed"),
        (["--engine", "ray", "--address", "here"], "address: 'here' is not allowed"),
    ],
)
def test_bad_options_are_one_line(
    options: list[str], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*EVALUATE, *options]) == 2
    captured = capsys.readouterr()
    assert text in captured.err
    assert captured.err.count("\n") == 1
    assert captured.out == ""


def test_a_cluster_that_does_not_answer_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        port = listener.getsockname()[1]
    assert main([*EVALUATE, "--engine", "ray", "--address", f"127.0.0.1:{port}"]) == 2
    assert "can be reached (Connection refused)" in capsys.readouterr().err
