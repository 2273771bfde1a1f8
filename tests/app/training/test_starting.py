import pytest

from app.choices import USUAL_PUSHES
from app.commands import StartTraining
from app.training.starting import training_config
from singulate.agents.registry import AGENTS


@pytest.mark.parametrize("agent", USUAL_PUSHES)
@pytest.mark.parametrize(("pushes", "every"), [(10, 20), (2_000, 40), (1_000_000, 1_000)])
def test_a_watched_run_saves_often_enough_to_be_followed(
    agent: str, pushes: int, every: int
) -> None:
    config = training_config(StartTraining(agent, "random-2", pushes, 3))
    assert (config.checkpoint_every, config.total_timesteps, config.seed) == (every, pushes, 3)
    assert config.env.action == AGENTS[agent].actions[0]


def test_options_of_a_command_come_first() -> None:
    command = StartTraining("dqn", "random-2", 500, 0, {"checkpoint_every": 7})
    assert training_config(command).checkpoint_every == 7
