"""How much of a distance map survives its code."""

from dataclasses import asdict, dataclass

import numpy as np
import torch

from singulate.agents.autoencoder.network import Autoencoder
from singulate.agents.autoencoder.scenes import Maps

BATCH = 256
"""Maps that are coded at a time."""


@dataclass(frozen=True)
class Quality:
    """Reconstructions against what they are of.

    Attributes:
        mean_absolute_error_px: Mean over all pixels of all maps [px].
        object_pixels_found: Share of the pixels on objects that are on one in the reconstruction.
        mask_overlap: Pixels on an object in both, as a share of those in either one
            (intersection over union).
        num_scenes: Maps that were compared.
    """

    mean_absolute_error_px: float
    object_pixels_found: float
    mask_overlap: float
    num_scenes: int

    def to_dict(self) -> dict[str, float | int]:
        """Plain values, for JSON."""
        return asdict(self)


def measure_quality(network: Autoencoder, maps: Maps) -> Quality:
    """Compare maps that the network has not seen, float32 (N, H, W) [px], with what it makes."""
    return compare_maps(reconstruct(network, maps), maps)


def reconstruct(network: Autoencoder, maps: Maps) -> Maps:
    """What is left of maps, float32 (N, H, W) [px], after coding and decoding."""
    with torch.no_grad():
        batches = torch.split(torch.from_numpy(maps), BATCH)
        parts = [network(batch).numpy() for batch in batches]
    return np.concatenate(parts)


def compare_maps(made: Maps, maps: Maps) -> Quality:
    """Compare reconstructions with what they are of, float32 (N, H, W) [px] each."""
    is_object, is_found = maps < 0.0, made < 0.0
    num_both = np.count_nonzero(is_object & is_found)
    return Quality(
        mean_absolute_error_px=round(float(np.abs(made - maps).mean()), 4),
        object_pixels_found=round(num_both / np.count_nonzero(is_object), 4),
        mask_overlap=round(num_both / np.count_nonzero(is_object | is_found), 4),
        num_scenes=len(maps),
    )
