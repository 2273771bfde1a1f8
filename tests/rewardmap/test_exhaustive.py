import numpy as np
import pytest

from singulate.agents.policy import SeesPoses
from singulate.engine import LocalEngine
from singulate.envs import EnvConfig
from singulate.evaluation import evaluate
from singulate.exceptions import InvalidValueError
from singulate.rewardmap.exhaustive import ExhaustivePolicy


def test_exhaustive_search_solves_what_its_grid_can() -> None:
    config = EnvConfig("random-3")
    fine = evaluate(ExhaustivePolicy(16), config, 6, seed=3)
    coarse = evaluate(ExhaustivePolicy(3), config, 6, seed=3)
    assert fine.num_successes == 6 > coarse.num_successes


def test_exhaustive_search_minds_the_goal() -> None:
    far, near = (EnvConfig("fixed-3", goal_separation=goal) for goal in (0.45, 0.05))
    policy = ExhaustivePolicy(16)
    assert evaluate(policy, near, 1).num_successes == 1
    assert evaluate(policy, far, 1).num_successes == 0


def test_exhaustive_search_does_not_depend_on_the_workers() -> None:
    config = EnvConfig("cluster-3")
    alone = evaluate(ExhaustivePolicy(8), config, 3, seed=1)
    with LocalEngine(num_workers=1) as engine:
        assert evaluate(ExhaustivePolicy(8), config, 3, seed=1, engine=engine) == alone


def test_exhaustive_search_needs_poses_and_an_empty_table_is_no_problem() -> None:
    policy = ExhaustivePolicy()
    assert isinstance(policy, SeesPoses)
    with pytest.raises(InvalidValueError, match="exhaustive"):
        policy.act(np.zeros((64, 64), np.float32))
    assert policy.act_on((), 0.1).length == 0.5
    policy.close()
    policy.close()
