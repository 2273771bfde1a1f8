from pathlib import Path

import numpy as np
import pytest

import singulate
from singulate.agents.loading import tensors_of
from singulate.agents.registry import agent_kind
from singulate.checkpoints import Manifest, save_checkpoint
from singulate.envs import EnvConfig
from singulate.exceptions import CheckpointError

ENV = EnvConfig("random-2", action="grid")
SMALL = {"net_arch": [8, 8]}


def _save(directory: Path, **changes: object) -> Path:
    kind = agent_kind("dqn")
    _, network = kind.build_policy(kind.make_config(SMALL), ENV)
    tensors = changes.pop("tensors", tensors_of(network))
    values = {"agent": "dqn", "agent_config": SMALL, "env_config": ENV.to_dict(), "step": 7}
    manifest = Manifest(**(values | changes))  # type: ignore[arg-type]
    return save_checkpoint(directory, tensors, manifest)  # type: ignore[arg-type]


def test_a_saved_policy_pushes_as_before(tmp_path: Path) -> None:
    kind = agent_kind("dqn")
    policy, network = kind.build_policy(kind.make_config(SMALL), ENV)
    loaded = singulate.load_policy(_save(tmp_path / "saved", tensors=tensors_of(network)))
    observation = np.random.default_rng(0).uniform(0, 50, (64, 64)).astype(np.float32)
    assert loaded.act(observation) == policy.act(observation)
    assert loaded.kind == "dqn"


@pytest.mark.parametrize(
    ("changes", "problem"),
    [
        ({"agent": "a2c"}, "a2c"),
        ({"agent_config": {"net_arch": [8], "depth": 3}}, "depth"),
        ({"agent_config": {"net_arch": [16, 8]}}, "q_net.0"),
        ({"env_config": {"scenario": "moon-2"}}, "moon-2"),
        ({"tensors": {"other": np.zeros(3, np.float32)}}, "unknown|missing"),
    ],
)
def test_what_does_not_fit_is_one_clear_line(
    tmp_path: Path, changes: dict[str, object], problem: str
) -> None:
    path = _save(tmp_path / "odd", **changes)
    with pytest.raises(CheckpointError, match=problem) as caught:
        singulate.load_policy(path)
    assert "\n" not in str(caught.value)


def test_a_run_without_checkpoints_says_so(tmp_path: Path) -> None:
    (tmp_path / "checkpoints").mkdir()
    with pytest.raises(CheckpointError, match="no intact checkpoint"):
        singulate.load_policy(tmp_path)
