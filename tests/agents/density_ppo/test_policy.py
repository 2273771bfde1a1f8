import time
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
import torch

import singulate
from singulate.agents.density_ppo.policy import DensityPolicy
from singulate.agents.loading import tensors_of
from singulate.agents.policy import HasStartDensity, Policy
from singulate.agents.registry import agent_kind
from singulate.checkpoints import Manifest, save_checkpoint
from singulate.envs import EnvConfig

OPINION = {"multimodal-ppo": 2.0, "mixture-ppo": 2.0, "fourier-ppo": 4.0}
"""By agent, the weights of its push head that make a density with strong opinions."""


def make_policy(agent: str, **settings: object) -> DensityPolicy:
    kind = agent_kind(agent)
    policy, _ = kind.build_policy(kind.make_config(settings), EnvConfig("random-2"))
    assert isinstance(policy, DensityPolicy)
    return policy


@pytest.fixture(params=OPINION)
def policy(request: pytest.FixtureRequest) -> DensityPolicy:
    """One with strong opinions, though untrained."""
    torch.manual_seed(0)
    policy = make_policy(request.param, net_arch=(8, 8))
    for parameter in policy.network.parameters():
        torch.nn.init.normal_(parameter, std=0.4)
    torch.nn.init.normal_(policy.network.push_net.push_head.weight, std=OPINION[request.param])
    return policy


@pytest.fixture
def observation() -> npt.NDArray[np.float32]:
    return np.random.default_rng(0).uniform(0, 40, (64, 64)).astype(np.float32)


def test_it_is_a_policy_with_a_start_density(policy: DensityPolicy) -> None:
    assert isinstance(policy, Policy)
    assert isinstance(policy, HasStartDensity)


def test_greedy_pushes_repeat(policy: DensityPolicy, observation: npt.NDArray[np.float32]) -> None:
    push = policy.act(observation)
    assert push == policy.act(observation)
    assert push.length == 0.5


def test_drawn_pushes_follow_the_start_density(
    policy: DensityPolicy, observation: npt.NDArray[np.float32]
) -> None:
    density = policy.start_density(observation)
    assert density.shape == (64, 64)
    assert density.dtype == np.float32
    assert density.sum() == pytest.approx(1.0, abs=1e-4)
    rng = np.random.default_rng(0)
    starts = np.array([policy.act(observation, rng).start for _ in range(1500)])
    counts, _, _ = np.histogram2d(-starts[:, 1], starts[:, 0], bins=8, range=[[-1, 1]] * 2)
    expected = density.reshape(8, 8, 8, 8).sum(axis=(1, 3))
    assert np.abs(counts / len(starts) - expected).max() < 0.05
    assert expected.max() > 0.05


def test_drawing_depends_on_the_generator_alone(
    policy: DensityPolicy, observation: npt.NDArray[np.float32]
) -> None:
    first = policy.act(observation, np.random.default_rng(3))
    torch.manual_seed(99)
    assert policy.act(observation, np.random.default_rng(3)) == first
    assert policy.act(observation, np.random.default_rng(4)) != first


def test_a_saved_policy_pushes_as_before(
    policy: DensityPolicy, observation: npt.NDArray[np.float32], tmp_path: Path
) -> None:
    manifest = Manifest(
        agent=policy.kind,
        agent_config={"net_arch": [8, 8]},
        env_config=EnvConfig("random-2").to_dict(),
        step=1,
    )
    path = save_checkpoint(tmp_path / "saved", tensors_of(policy.network), manifest)
    loaded = singulate.load_policy(path)
    assert loaded.act(observation) == policy.act(observation)
    assert isinstance(loaded, DensityPolicy)
    assert np.array_equal(loaded.start_density(observation), policy.start_density(observation))


@pytest.mark.slow
@pytest.mark.parametrize("agent", OPINION)
def test_acting_takes_less_than_5_ms_of_one_core(
    agent: str, observation: npt.NDArray[np.float32], pace: float
) -> None:
    policy = make_policy(agent)
    policy.act(observation)
    spent = []
    for _ in range(20):
        began = time.process_time()
        policy.act(observation)
        spent.append(time.process_time() - began)
    assert np.median(spent) < 5e-3 * pace
