from dataclasses import fields

import pytest

from singulate.agents.registry import AGENTS
from singulate.agents.settings import settings_of
from singulate.exceptions import InvalidValueError


@pytest.mark.parametrize("agent", AGENTS)
def test_every_setting_is_explained(agent: str) -> None:
    settings = settings_of(agent)
    assert [each.name for each in settings] == [f.name for f in fields(AGENTS[agent].config_class)]
    assert all(len(each.meaning) > 10 for each in settings)
    defaults = AGENTS[agent].make_config({})
    assert all(each.default == getattr(defaults, each.name) for each in settings)


def test_a_meaning_of_several_lines_is_whole() -> None:
    (tau,) = [each for each in settings_of("dqn") if each.name == "tau"]
    assert tau.meaning.startswith("How far each of them goes")
    assert tau.meaning.endswith("last few updates.")


def test_there_is_no_such_agent() -> None:
    with pytest.raises(InvalidValueError, match="agent: 'a2c'"):
        settings_of("a2c")
