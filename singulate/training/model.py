"""Builds the model that a run trains."""

from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.autoencoder.network import Encoder
from singulate.agents.frozen_encoder import fill_encoder, load_encoder
from singulate.training.config import TrainingConfig


def encoder_of(config: TrainingConfig) -> Encoder | None:
    """The encoder that a new training looks through, if its agent has one.

    Raises:
        CheckpointError: If it is missing, damaged, or no autoencoder.
    """
    directory = config.agent_config.get("encoder")
    return None if directory is None else load_encoder(directory)


def build_training_model(
    config: TrainingConfig, envs: VecEnv, encoder: Encoder | None = None
) -> BaseAlgorithm:
    """An untrained model that learns in these environments and prints nothing.

    Args:
        config: The run's settings.
        envs: Its environments.
        encoder: See `encoder_of`; None also where a checkpoint is about to bring it.
    """
    model = config.kind.build_model(
        config.resolved_agent_config, envs, config.env.observation, config.seed
    )
    if encoder is not None:
        fill_encoder(model.policy, encoder)
    model.set_logger(Logger(folder=None, output_formats=[]))
    return model
