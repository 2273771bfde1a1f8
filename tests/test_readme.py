"""What README.md tells people to type."""

import argparse
import re
import shlex
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from singulate.cli import COMMANDS
from singulate.geometry import Push

ROOT = Path(__file__).resolve().parents[1]
README = (ROOT / "README.md").read_text("utf-8")
FENCED = re.findall(r"^singulate .+$", README, re.MULTILINE)
IN_THE_TEXT = re.findall(r"`(singulate [^\s`]+ [^`]+)`", README)
LINES = sorted({shlex.join(shlex.split(line, comments=True)) for line in FENCED + IN_THE_TEXT})


def test_the_python_example_singulates_a_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    examples = re.findall(r"^```python\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
    monkeypatch.chdir(ROOT)
    found: dict[str, Any] = {}
    for example in examples:
        exec(example, found)
    found["env"].close()
    assert found["observation"].shape == (64, 64)
    assert isinstance(found["push"], Push)
    assert (found["values"].shape, found["values"].dtype) == ((4, 64, 64), np.float32)
    assert found["info"]["push"].start == pytest.approx(found["push"].start, abs=1e-6)
    assert found["info"]["is_success"]
    rewards, agreed = found["rewards"], found["values"]
    assert (rewards.shape, rewards.dtype) == ((4, 64, 64), np.float32)
    assert rewards.flat[agreed.argmax()] > 1000.0
    assert set(found["info"]["reward_terms"]) == {"start", "distance", "inside", "success"}


@pytest.mark.parametrize("line", LINES)
def test_every_command_line_can_be_parsed(line: str) -> None:
    _, name, *arguments = shlex.split(line)
    parser = argparse.ArgumentParser()
    import_module(f"singulate.cli.{name}").add_parser(parser.add_subparsers())
    assert callable(parser.parse_args([name, *arguments]).run)


def test_all_commands_are_shown() -> None:
    assert {line.split()[1] for line in LINES} == set(COMMANDS)
