"""An autoencoder that several cells look through: trained once, by whoever needs it first."""

import fcntl
import os
from pathlib import Path

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.checkpoints import verify_checkpoint
from singulate.exceptions import CheckpointError

NUM_UNSEEN = 1000
"""Scenes that the quality of an autoencoder is measured on."""


def ensure_autoencoder(config: AutoencoderConfig, directory: Path) -> Path:
    """Train an autoencoder unless it is there; others who need it wait meanwhile.

    Interrupted, it leaves nothing and starts anew the next time: it takes two minutes.

    Args:
        config: What decides it.
        directory: Where it lies, or shall lie; nothing else may be put there.

    Returns:
        `directory`.

    Raises:
        CheckpointError: If it cannot be written.
        OSError: If the place cannot be written.
    """
    directory.parent.mkdir(parents=True, exist_ok=True)
    lock = os.open(directory.with_name(f".{directory.name}.lock"), os.O_RDWR | os.O_CREAT, 0o644)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not _is_intact(directory):
            _train(config, directory)
    finally:
        os.close(lock)
    return directory


def _is_intact(directory: Path) -> bool:
    try:
        verify_checkpoint(directory)
    except CheckpointError:
        return False
    return True


def _train(config: AutoencoderConfig, directory: Path) -> None:
    import torch

    from singulate.agents.autoencoder.training import make_autoencoder

    torch.set_num_threads(1)  # as the trainings that follow, whatever this process did before
    torch.set_flush_denormal(True)
    make_autoencoder(config, NUM_UNSEEN, directory)
