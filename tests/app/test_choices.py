import pytest

from app.choices import AGENTS, SCENARIOS
from singulate.agents.registry import AGENTS as TRAINABLE
from singulate.simulation import make_scenario


@pytest.mark.parametrize("name", SCENARIOS)
def test_every_offered_scenario_exists(name: str):
    assert make_scenario(name).name == name


def test_every_agent_that_can_be_trained_is_offered():
    assert sorted(AGENTS) == sorted(TRAINABLE)
