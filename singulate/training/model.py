"""Builds the model that a run trains."""

from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.vec_env import VecEnv

from singulate.training.config import TrainingConfig


def build_training_model(config: TrainingConfig, envs: VecEnv) -> BaseAlgorithm:
    """An untrained model that learns in these environments and prints nothing."""
    model = config.kind.build_model(
        config.resolved_agent_config, envs, config.env.observation, config.seed
    )
    model.set_logger(Logger(folder=None, output_formats=[]))
    return model
