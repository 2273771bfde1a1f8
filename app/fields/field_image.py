"""Values to colours."""

import math

import numpy as np
import numpy.typing as npt

from app.fields.colormaps import SEGMENT_COLOURS, Colormap, hex_to_rgb

Rgba = npt.NDArray[np.uint8]
Span = tuple[float, float]

FAINTEST = 0.15
"""Share of the opacity that the lowest value of a fading field keeps."""


def value_span(*maps: npt.NDArray[np.generic], is_diverging: bool = False) -> Span:
    """Smallest and largest finite value of some maps.

    Args:
        maps: Any shapes; cells that are not finite are left out.
        is_diverging: Make the span symmetric about zero.

    Returns:
        (low, high) with low < high; (0, 1) where no value is finite.
    """
    lows, highs = [], []
    for values in maps:
        finite = values[np.isfinite(values)]
        if finite.size:
            lows.append(float(finite.min()))
            highs.append(float(finite.max()))
    if not lows:
        return 0.0, 1.0
    low, high = min(lows), max(highs)
    if is_diverging:
        high = max(abs(low), abs(high))
        low = -high
    if high - low < 1e-9:
        return low, low + max(1.0, abs(low)) * 1e-3
    return low, high


def field_image(
    values: npt.NDArray[np.generic],
    span: Span,
    colormap: Colormap,
    opacity: float = 1.0,
    fades: bool = False,
) -> Rgba:
    """Colour a map.

    Args:
        values: (H, W); cells that are not finite become transparent.
        span: Values at the two ends of the colour map; values beyond are clipped.
        colormap: Which colours.
        opacity: 0 (invisible) to 1.
        fades: Let low values fade away, so that a density leaves the table visible.

    Returns:
        uint8 (H, W, 4).
    """
    low, high = span
    finite = np.isfinite(values)
    share = (np.where(finite, values, low).astype(np.float64) - low) / (high - low)
    share = np.clip(share, 0.0, 1.0)
    image = np.empty((*values.shape, 4), dtype=np.uint8)
    image[..., :3] = colormap.table[(share * 255.0).round().astype(np.uint8)]
    alpha = np.full(values.shape, opacity)
    if fades:
        alpha *= FAINTEST + (1.0 - FAINTEST) * np.sqrt(share)
    image[..., 3] = np.where(finite, alpha * 255.0, 0.0).round().astype(np.uint8)
    return image


def picture_image(rgb: npt.NDArray[np.uint8], opacity: float = 1.0) -> Rgba:
    """A camera picture uint8 (H, W, 3) with an opacity, uint8 (H, W, 4)."""
    alpha = np.full((*rgb.shape[:2], 1), round(opacity * 255.0), dtype=np.uint8)
    return np.concatenate([rgb, alpha], axis=2)


def segment_image(labels: npt.NDArray[np.int32]) -> Rgba:
    """Segments in different colours, background transparent.

    Args:
        labels: int32 (H, W); 0 is background, segments count from 1.

    Returns:
        uint8 (H, W, 4).
    """
    palette = np.array([hex_to_rgb(colour) for colour in SEGMENT_COLOURS], dtype=np.uint8)
    image = np.zeros((*labels.shape, 4), dtype=np.uint8)
    inside = labels > 0
    image[inside, :3] = palette[(labels[inside] - 1) % len(palette)]
    image[inside, 3] = 255
    return image


def best_cell(values: npt.NDArray[np.generic]) -> tuple[int, int] | None:
    """(row, col) of the largest finite value of a map (H, W), None where no value is finite."""
    if not np.isfinite(values).any():
        return None
    flat = int(np.where(np.isfinite(values), values, -math.inf).argmax())
    return flat // values.shape[1], flat % values.shape[1]
