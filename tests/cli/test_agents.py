import json

import pytest

from singulate.agents.registry import AGENTS
from singulate.cli import main


def test_agents_and_their_settings(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["agents", "--json"]) == 0
    assert list(json.loads(capsys.readouterr().out)) == list(AGENTS)
    assert main(["agents"]) == 0
    assert "spatial" in capsys.readouterr().out
    assert main(["agents", "dqn", "--json"]) == 0
    settings = {each["name"]: each for each in json.loads(capsys.readouterr().out)}
    assert settings["net_arch"]["default"] == [128, 64, 64, 32, 16]
    assert main(["agents", "dqn"]) == 0
    assert "exploration_aimed" in capsys.readouterr().out


def test_an_unknown_agent_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["agents", "a2c"]) == 2
    error = capsys.readouterr().err
    assert "agent: 'a2c' is not allowed" in error and error.count("\n") == 1
