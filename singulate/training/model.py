"""Builds the model that a run trains."""

from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.vec_env import DummyVecEnv

from singulate.agents.reward_scale import ScaledReward
from singulate.training.config import TrainingConfig
from singulate.training.seeded_episodes import SeededEpisodes


def build_training_model(config: TrainingConfig, episodes: SeededEpisodes) -> BaseAlgorithm:
    """An untrained model that learns on these episodes with scaled rewards and prints nothing."""
    env = DummyVecEnv([lambda: ScaledReward(episodes)])
    model = config.kind.build_model(
        config.resolved_agent_config, env, config.env.observation, config.seed
    )
    model.set_logger(Logger(folder=None, output_formats=[]))
    return model
