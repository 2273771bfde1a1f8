import pytest

from singulate.envs import EnvConfig
from singulate.exceptions import InvalidValueError
from singulate.training.config import TrainingConfig

GRID = EnvConfig("random-2", action="grid")


def test_it_survives_a_round_trip_with_every_default_filled_in() -> None:
    config = TrainingConfig("dqn", GRID, 100, agent_config={"net_arch": (8, 8)})
    values = config.to_dict()
    assert values["agent_config"]["gamma"] == 0.9
    assert TrainingConfig.from_dict(values) == config


@pytest.mark.parametrize(
    ("changes", "key"),
    [
        ({"agent": "a2c"}, "agent"),
        ({"total_timesteps": 0}, "steps"),
        ({"total_timesteps": 2.0}, "steps"),
        ({"seed": -1}, "seed"),
        ({"speed": 2}, "speed"),
        ({"env": 3}, "env"),
        ({"env": {"scenario": "moon-1"}}, "scenario"),
        ({"agent_config": {"depth": 2}}, "depth"),
        ({"agent_config": [1]}, "dqn"),
        ({"checkpoint_every": 0}, "checkpoint_every"),
        ({"num_envs": 0}, "num_envs"),
        ({"num_envs": 2, "num_workers": 3}, "num_workers"),
    ],
)
def test_bad_values_name_the_key(changes: dict[str, object], key: str) -> None:
    values = TrainingConfig("dqn", GRID, 100).to_dict() | changes
    with pytest.raises(InvalidValueError, match=key):
        TrainingConfig.from_dict(values)


def test_missing_keys_are_named() -> None:
    with pytest.raises(InvalidValueError, match="total_timesteps"):
        TrainingConfig.from_dict({"agent": "dqn", "env": {}})


def test_an_agent_needs_an_action_encoding_that_it_can_use() -> None:
    with pytest.raises(InvalidValueError, match="grid for dqn"):
        TrainingConfig("dqn", EnvConfig(action="point"), 100)
    with pytest.raises(InvalidValueError, match="point, start_end for ppo"):
        TrainingConfig("ppo", GRID, 100)


def test_ppo_divides_the_pushes_between_updates_among_environments() -> None:
    assert TrainingConfig("ppo", EnvConfig(), 100, num_envs=4).agent_config["n_steps"] == 2048
    with pytest.raises(InvalidValueError, match=r"num_envs: 3 .* a divisor of n_steps \(2048\)"):
        TrainingConfig("ppo", EnvConfig(), 100, num_envs=3)


def test_a_single_environment_lives_in_the_trainer() -> None:
    assert TrainingConfig("dqn", GRID, 100).resolved_num_workers == 0
    assert TrainingConfig("dqn", GRID, 100, num_envs=2).resolved_num_workers >= 1
    assert TrainingConfig("dqn", GRID, 100, num_envs=2, num_workers=0).resolved_num_workers == 0
