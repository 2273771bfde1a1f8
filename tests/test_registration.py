"""The ways in which Gymnasium learns of ``singulate/Push-v0``, each in a fresh interpreter."""

import subprocess
import sys

import pytest

ENTRY_POINT = """
import gymnasium
from importlib.metadata import entry_points
(plugin,) = entry_points(group="gymnasium.envs", name="singulate")
plugin.load()()
"""
BY_ITS_MODULE = """
import gymnasium
gymnasium.make("singulate:singulate/Push-v0").close()
"""


@pytest.mark.parametrize(
    ("code", "is_known"),
    [
        ("import gymnasium", False),
        ("import gymnasium, singulate", True),
        (ENTRY_POINT, True),
        (BY_ITS_MODULE, True),
    ],
)
def test_the_environment_is_registered(code: str, is_known: bool) -> None:
    code += "\nprint('singulate/Push-v0' in gymnasium.registry)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.stdout == f"{is_known}\n", done.stderr
