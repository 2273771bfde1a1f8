from stable_baselines3.common.vec_env import DummyVecEnv

from singulate.agents.dqn.config import DQNConfig
from singulate.agents.dqn.model import build_model
from singulate.agents.reward_scale import ScaledReward
from singulate.envs import PushEnv
from singulate.envs.outcome_kind import EMPTY_PUSH_LIMIT


def _share_that_moves_nothing(aimed: float) -> float:
    """Of 120 explored pushes on scenes of two blocks."""
    env = PushEnv(scenario="random-2", action="grid")
    config = DQNConfig(
        net_arch=(8,), buffer_size=200, learning_starts=200, exploration_aimed=aimed
    )  # fmt: skip
    model = build_model(config, DummyVecEnv([lambda: ScaledReward(env)]), "distance_map", seed=1)
    moved: list[float] = []

    def note(values: dict[str, object], _: object) -> bool:
        (info,) = values["infos"]  # type: ignore[misc]
        moved.append(info["outcome"].moved)
        return True

    model.learn(120, callback=note)
    env.close()
    return sum(distance < EMPTY_PUSH_LIMIT for distance in moved) / len(moved)


def test_aimed_exploration_meets_objects_far_more_often() -> None:
    uniform, aimed = _share_that_moves_nothing(0.0), _share_that_moves_nothing(1.0)
    assert uniform > 0.8
    assert aimed < 0.5
