import numpy as np
import pytest
import torch

from singulate.agents.off_policy.policy import ActorCriticPolicy
from singulate.agents.off_policy.values import lower_values
from singulate.agents.policy import HasQMap
from singulate.agents.registry import agent_kind
from singulate.envs import EnvConfig
from singulate.geometry import Direction, Push, Workspace

OBSERVATION = np.random.default_rng(1).uniform(-1, 40, (64, 64)).astype(np.float32)


def make_policy(agent: str, action: str = "point") -> ActorCriticPolicy:
    torch.manual_seed(0)
    kind = agent_kind(agent)
    config = kind.make_config({"net_arch": [16, 8]})
    policy, _ = kind.build_policy(config, EnvConfig("random-2", action=action))
    assert isinstance(policy, ActorCriticPolicy)
    return policy


@pytest.mark.parametrize("agent", ["sac", "td3"])
@pytest.mark.parametrize("action", ["point", "start_end"])
def test_the_map_holds_the_critics_lower_value_of_each_push(agent: str, action: str) -> None:
    policy = make_policy(agent, action)
    assert isinstance(policy, HasQMap)
    values = policy.q_map(OBSERVATION)
    assert (values.shape, values.dtype) == ((4, 64, 64), np.float32)
    observations = torch.as_tensor(OBSERVATION[None])
    for direction, row, col in ((0, 40, 33), (1, 22, 5), (2, 0, 63), (3, 63, 0)):
        x, y = Workspace().row_col_to_xy(row, col)
        push = Push.cardinal((x, y), Direction(direction), 0.5)
        c = (direction + 0.5) / 2.0 - 1.0
        encoded = [x, y, c] if action == "point" else [x, y, *np.clip(push.end, -1.0, 1.0)]
        with torch.no_grad():
            found = lower_values(
                policy.network.critic, observations, torch.tensor([encoded], dtype=torch.float32)
            )
        assert values[direction, row, col] == pytest.approx(1000.0 * float(found[0]), rel=1e-3)
        assert policy.predict_value(OBSERVATION, push) == pytest.approx(
            values[direction, row, col], rel=1e-4
        )


def test_the_lower_of_two_critics_counts() -> None:
    critic = make_policy("td3").network.critic
    generator = torch.Generator().manual_seed(0)
    pushes = torch.rand(50, 3, generator=generator) * 2 - 1
    pictures = torch.as_tensor(OBSERVATION).expand(50, -1, -1)
    with torch.no_grad():
        one, other = critic(pictures, pushes)
        found = lower_values(critic, pictures, pushes)
    assert torch.equal(found, torch.minimum(one, other)[:, 0])
    assert (one > other).any() or (one < other).any()
