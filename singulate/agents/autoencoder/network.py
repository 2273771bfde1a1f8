"""The network: a convolutional encoder down to a few numbers, and a decoder back to the map."""

import torch
from torch import nn

IMAGE_SIZE = 64
CODE_SIZE = 32
"""Numbers that a distance map is squeezed into, a 128th of its pixels; five blocks, the most that
it is trained on, are 15: two coordinates and a side each."""

PATCH_SIZE = 4
"""The encoder's first layer looks at patches of this many pixels along each side, which is half
the work of halving the image twice."""
CHANNELS = (16, 32, 64)
"""Of the encoder's convolutions; the second and third halve the image."""
NUM_HIDDEN = 256
"""Width of the decoder's one hidden layer. Every pixel depends on all blocks, and on one core two
full layers are faster than convolutions back to the full size."""

MASK_WEIGHT = 0.3
"""Weight of the mask in the loss, beside a weight of 1 for the signed roots."""
MASK_STEEPNESS = 2.0
"""Logit of a pixel's being on an object where its signed root is -1."""


def to_root(maps: torch.Tensor) -> torch.Tensor:
    """Signed square root of distances [px], -1 inside objects still.

    Pushes are decided near the objects, where this keeps small differences large.
    """
    return maps.sign() * maps.abs().sqrt()


def from_root(roots: torch.Tensor) -> torch.Tensor:
    """The inverse of `to_root`."""
    return roots * roots.abs()


class Encoder(nn.Module):
    """Distance maps to codes."""

    def __init__(self) -> None:
        super().__init__()
        few, more, many = CHANNELS
        self.convolutions = nn.Sequential(
            nn.Conv2d(1, few, PATCH_SIZE, stride=PATCH_SIZE),
            nn.ReLU(),
            nn.Conv2d(few, more, 3, stride=2, padding=1),
            nn.ReLU(),
            nn.Conv2d(more, many, 3, stride=2, padding=1),
            nn.ReLU(),
            nn.Flatten(),
        )
        size = IMAGE_SIZE // (4 * PATCH_SIZE)
        self.code = nn.Linear(many * size * size, CODE_SIZE)

    def forward(self, maps: torch.Tensor) -> torch.Tensor:
        """Map (batch, 64, 64) [px] to (batch, CODE_SIZE)."""
        code: torch.Tensor = self.code(self.convolutions(to_root(maps)[:, None]))
        return code


class Decoder(nn.Module):
    """Codes to signed roots of distance maps."""

    def __init__(self) -> None:
        super().__init__()
        self.hidden = nn.Linear(CODE_SIZE, NUM_HIDDEN)
        self.pixels = nn.Linear(NUM_HIDDEN, IMAGE_SIZE * IMAGE_SIZE)

    def forward(self, code: torch.Tensor) -> torch.Tensor:
        """Map (batch, CODE_SIZE) to (batch, 64, 64), as `to_root`."""
        pixels: torch.Tensor = self.pixels(torch.relu(self.hidden(code)))
        return pixels.reshape(-1, IMAGE_SIZE, IMAGE_SIZE)


class Autoencoder(nn.Module):
    """An encoder and a decoder that are trained together."""

    def __init__(self) -> None:
        super().__init__()
        self.encoder = Encoder()
        self.decoder = Decoder()

    def forward(self, maps: torch.Tensor) -> torch.Tensor:
        """What is left of maps, (batch, 64, 64) [px], after coding and decoding."""
        return from_root(self.decoder(self.encoder(maps)))

    @torch.no_grad()
    def standardise_code(self, maps: torch.Tensor) -> None:
        """Give each number of the code mean 0 and standard deviation 1 over `maps`.

        Encoder and decoder change together, so reconstructions stay the same.

        Args:
            maps: (N, 64, 64) [px].
        """
        codes = torch.cat([self.encoder(batch) for batch in torch.split(maps, 256)])
        mean, deviation = codes.mean(dim=0), codes.std(dim=0, correction=0).clamp(min=1e-6)
        code, hidden = self.encoder.code, self.decoder.hidden
        code.weight.copy_(code.weight / deviation[:, None])
        code.bias.copy_((code.bias - mean) / deviation)
        hidden.bias.copy_(hidden.bias + hidden.weight @ mean)
        hidden.weight.copy_(hidden.weight * deviation)


def reconstruction_loss(network: Autoencoder, maps: torch.Tensor) -> torch.Tensor:
    """How far the reconstruction of maps, (batch, 64, 64) [px], is from them.

    The squared error of the signed roots, and, because a wrong sign is a wrong mask but no large
    error, the cross-entropy of the sign.
    """
    roots, made = to_root(maps), network.decoder(network.encoder(maps))
    is_object = (maps < 0.0).float()
    sign = nn.functional.binary_cross_entropy_with_logits(-MASK_STEEPNESS * made, is_object)
    return nn.functional.mse_loss(made, roots) + MASK_WEIGHT * sign
