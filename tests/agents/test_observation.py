from typing import Any

import numpy as np
import pytest

from singulate.agents.observation import batch_of_one, checked_observation
from singulate.agents.registry import AGENTS, agent_kind
from singulate.envs import EnvConfig
from singulate.exceptions import InvalidValueError


def test_numbers_of_any_type_become_one_float32_image() -> None:
    image = checked_observation(np.ones((64, 64), np.int64), 64)
    assert image.dtype == np.float32 and image.shape == (64, 64)
    assert batch_of_one(image.tolist(), 64).shape == (1, 64, 64)


@pytest.mark.parametrize("agent", AGENTS)
@pytest.mark.parametrize(
    ("observation", "said"),
    [
        (np.ones((32, 32), np.float32), r"shape \(32, 32\)"),
        (np.ones((1, 64, 64), np.float32), r"shape \(1, 64, 64\)"),
        (np.full((64, 64), np.nan, np.float32), "not finite"),
        ("a picture", "'str'"),
    ],
)
def test_no_policy_pushes_by_what_is_no_picture(agent: str, observation: Any, said: str) -> None:
    kind = agent_kind(agent)
    env = EnvConfig(action=kind.actions[0])
    policy, _ = kind.build_policy(kind.make_config({}), env)
    with pytest.raises(InvalidValueError, match=f"observation: .*{said}.* allowed: one image"):
        policy.act(observation)
