"""Trains an autoencoder on maps of random scenes."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import torch

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.autoencoder.network import Autoencoder, reconstruction_loss
from singulate.agents.autoencoder.quality import Quality, measure_quality
from singulate.agents.autoencoder.scenes import Maps, draw_maps
from singulate.agents.autoencoder.storing import save_autoencoder
from singulate.agents.dqn.symmetry import NUM_SYMMETRIES, transform_images

OnProgress = Callable[[str, int, int], None]
"""Called with the step, how much of it is done, and how much it is."""


def make_autoencoder(
    config: AutoencoderConfig,
    num_unseen: int,
    directory: Path,
    on_progress: OnProgress = lambda step, done, total: None,
) -> Quality:
    """Draw scenes, train, measure and save.

    Args:
        config: What decides the weights.
        num_unseen: Scenes to measure the quality on; no training draws them.
        directory: Where the autoencoder goes.
        on_progress: See `OnProgress`.

    Returns:
        How good it is on the unseen scenes.

    Raises:
        CheckpointError: If it cannot be written.
    """
    for_training, for_network, for_unseen = np.random.SeedSequence(config.seed).spawn(3)
    total = config.num_scenes + num_unseen
    maps = draw_maps(
        config.scenario,
        config.num_scenes,
        np.random.default_rng(for_training),
        lambda done: on_progress("Scenes", done, total),
    )
    unseen = draw_maps(
        config.scenario,
        num_unseen,
        np.random.default_rng(for_unseen),
        lambda done: on_progress("Scenes", config.num_scenes + done, total),
    )
    network, losses = train_autoencoder(
        config,
        maps,
        np.random.default_rng(for_network),
        lambda done: on_progress("Training", done, config.num_updates),
    )
    quality = measure_quality(network, unseen)
    notes = {"quality": quality.to_dict(), "final_loss": float(np.mean(losses[-100:]))}
    save_autoencoder(directory, network, config, notes)
    return quality


def train_autoencoder(
    config: AutoencoderConfig,
    maps: Maps,
    rng: np.random.Generator,
    on_progress: Callable[[int], None] = lambda done: None,
) -> tuple[Autoencoder, list[float]]:
    """Train a network to give back what it saw.

    At the end its code is shifted and scaled to mean 0 and standard deviation 1 over `maps`.

    Args:
        config: Its settings.
        maps: float32 (N, H, W) [px].
        rng: Decides the first weights, and which maps are seen and how they are turned.
        on_progress: Called with the number of gradient steps so far.

    Returns:
        The network, and the loss of each gradient step.
    """
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(int(rng.integers(2**63)))
        network = Autoencoder()
    optimizer = torch.optim.Adam(network.parameters(), lr=config.learning_rate, fused=True)
    losses = []
    for step in range(config.num_updates):
        for group in optimizer.param_groups:
            group["lr"] = config.learning_rate * (1.0 - step / config.num_updates)
        chosen = maps[rng.integers(len(maps), size=config.batch_size)]
        turned = transform_images(chosen, int(rng.integers(NUM_SYMMETRIES)))
        batch = torch.from_numpy(np.ascontiguousarray(turned))
        loss = reconstruction_loss(network, batch)
        optimizer.zero_grad()
        torch.autograd.backward(loss)
        optimizer.step()
        losses.append(loss.item())
        on_progress(step + 1)
    network.eval().standardise_code(torch.from_numpy(maps))
    return network, losses
