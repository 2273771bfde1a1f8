"""The weights that come with the package still do what was measured when they were published."""

import statistics

import pytest

from singulate import load_policy
from singulate.checkpoints import verify_checkpoint
from singulate.envs import EnvConfig
from singulate.evaluation import evaluate
from singulate.paths import shipped_checkpoints_directory

NAMES = sorted(path.parent.name for path in shipped_checkpoints_directory().glob("*/manifest.json"))


@pytest.mark.parametrize("name", NAMES)
def test_they_push_as_well_as_was_measured(name: str) -> None:
    directory = shipped_checkpoints_directory() / name
    manifest, policy = verify_checkpoint(directory), load_policy(directory)
    way = "drawing" if policy.is_random else "greedy"
    measured = manifest.notes["measured"].items()
    rates = [each["success_rate"] for how, each in measured if how.startswith(way)]
    env, seed = EnvConfig.from_dict(manifest.env_config), manifest.notes["evaluation_seed"]
    found = evaluate(policy, env, 40, seed, sample=policy.is_random)
    # Three standard deviations of forty scenes; random pushes reach 1 %.
    assert found.success_rate == pytest.approx(statistics.mean(rates), abs=0.24)
