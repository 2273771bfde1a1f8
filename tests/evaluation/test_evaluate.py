import numpy as np
import pytest

from singulate.agents.policy import FloatMap
from singulate.agents.random_policy import RandomPolicy
from singulate.engine import LocalEngine
from singulate.envs import EnvConfig, PushEnv, scene_seed
from singulate.evaluation import Evaluator, evaluate
from singulate.exceptions import InvalidValueError
from singulate.geometry import Push


class OnePush:
    """Always makes the same push."""

    kind = "one_push"
    observation = "distance_map"
    is_random = False

    def __init__(self, push: Push) -> None:
        self.push = push

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        return self.push

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        return None


FIXED = EnvConfig("fixed-2")
FAR_AWAY = Push((0.9, 0.9), (1.0, 0.0), 0.05)
INSIDE = Push((0.1, 0.0), (1.0, 0.0), 0.5)


def test_results_do_not_depend_on_the_workers() -> None:
    alone = evaluate(RandomPolicy(), EnvConfig("random-3"), 50, seed=2)
    with LocalEngine(num_workers=2) as engine:
        together = evaluate(RandomPolicy(), EnvConfig("random-3"), 50, seed=2, engine=engine)
    assert alone == together
    assert alone.num_episodes == 50


def test_scenes_are_those_of_the_environment() -> None:
    evaluator, env = Evaluator(OnePush(FAR_AWAY), EnvConfig("random-2")), PushEnv()
    evaluator.play(3, 11)
    _, info = env.reset(seed=scene_seed("evaluation", 3, 11))
    assert evaluator._env.task.scene.poses == info["poses"]
    evaluator.close()
    env.close()


@pytest.mark.parametrize(("push", "kind"), [(FAR_AWAY, "empty"), (INSIDE, "inside")])
def test_failures_are_counted_by_kind(push: Push, kind: str) -> None:
    evaluation = evaluate(OnePush(push), FIXED, 3)
    assert evaluation.failures == {kind: 3}
    assert evaluation.success_rate == 0.0
    assert evaluation.mean_reward == pytest.approx(sum(evaluation.mean_reward_by_term.values()))


def test_an_episode_may_take_several_pushes() -> None:
    config = EnvConfig("fixed-2", max_pushes=4)
    evaluation = evaluate(OnePush(FAR_AWAY), config, 2)
    single = evaluate(OnePush(FAR_AWAY), FIXED, 2)
    assert evaluation.mean_pushes == 4.0
    assert evaluation.mean_reward == pytest.approx(4 * single.mean_reward)


def test_warm_up_weights_do_not_count() -> None:
    schedule = EnvConfig("fixed-2", reward="start_then_separation")
    assert evaluate(OnePush(FAR_AWAY), schedule, 1).mean_reward == 0.0


def test_a_sampled_policy_explores_the_same_way_each_time() -> None:
    class Sometimes(OnePush):
        def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
            return INSIDE if rng is not None and rng.random() < 0.5 else FAR_AWAY

    policy = Sometimes(FAR_AWAY)
    assert evaluate(policy, FIXED, 20).failures == {"empty": 20}
    sampled = evaluate(policy, FIXED, 20, sample=True)
    assert set(sampled.failures) == {"empty", "inside"}
    assert sampled == evaluate(policy, FIXED, 20, sample=True)


@pytest.mark.parametrize(("episodes", "seed"), [(0, 0), (1, -1)])
def test_bad_numbers_are_refused(episodes: int, seed: int) -> None:
    with pytest.raises(InvalidValueError):
        evaluate(RandomPolicy(), FIXED, episodes, seed)
