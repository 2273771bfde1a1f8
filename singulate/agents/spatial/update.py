"""One gradient step of the spatial agent."""

import torch

from singulate.agents.spatial.config import SpatialConfig
from singulate.agents.spatial.networks import SpatialNetworks
from singulate.agents.spatial.replay import PushBatch
from singulate.agents.spatial.window import read_between

MAX_GRAD_NORM = 1.0


def gradient_step(networks: SpatialNetworks, batch: PushBatch, config: SpatialConfig) -> float:
    """Improve the network on a batch, by Adam on the Huber loss of the executed pushes alone.

    Args:
        networks: The network that learns and its average.
        batch: The pushes.
        config: The agent's settings.

    Returns:
        The loss.
    """
    values = read_between(networks.learning(batch.canvases), batch.pixels)
    loss = torch.nn.functional.smooth_l1_loss(values, batch.rewards, beta=config.huber_beta)
    networks.optimizer.zero_grad()
    torch.autograd.backward(loss)
    torch.nn.utils.clip_grad_norm_(networks.learning.parameters(), MAX_GRAD_NORM)
    networks.optimizer.step()
    networks.follow(config.average_decay)
    return loss.item()
