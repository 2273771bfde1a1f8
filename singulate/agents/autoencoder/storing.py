"""Autoencoders on disk: as a checkpoint, so written as a whole and read without pickle."""

from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.autoencoder.network import Autoencoder
from singulate.agents.loading import load_tensors, tensors_of
from singulate.checkpoints import Manifest, read_checkpoint, save_checkpoint
from singulate.exceptions import CheckpointError

KIND = "autoencoder"
"""What stands in the manifest where agents have their kind."""


def save_autoencoder(
    directory: Path, network: Autoencoder, config: AutoencoderConfig, notes: Mapping[str, Any]
) -> Path:
    """Save an autoencoder atomically; one that was there is replaced.

    Args:
        directory: Where it goes; parents are made.
        network: The trained network.
        config: What it was trained with.
        notes: Anything else worth keeping, plain values for JSON.

    Raises:
        CheckpointError: If it cannot be written, or a weight is not finite.
    """
    manifest = Manifest(KIND, asdict(config), {}, config.num_updates, notes)
    return save_checkpoint(directory, tensors_of(network), manifest)


def load_autoencoder(directory: Path) -> Autoencoder:
    """Load an autoencoder; nothing in its files is ever executed.

    Raises:
        CheckpointError: If it is missing, damaged, or no autoencoder.
    """
    checkpoint = read_checkpoint(directory, with_files=False)
    if checkpoint.manifest.agent != KIND:
        kind = checkpoint.manifest.agent
        raise CheckpointError(f"{directory}: is an agent ({kind:.40}), not an {KIND}")
    network = Autoencoder()
    load_tensors(network, checkpoint.tensors)
    return network.eval()
