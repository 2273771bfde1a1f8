"""Pictures small enough to travel inside a piece of HTML."""

import base64

import cv2
import numpy as np
import numpy.typing as npt


def png_bytes(image: npt.NDArray[np.uint8]) -> bytes:
    """Encode a picture losslessly.

    Args:
        image: uint8 (H, W, 3) or (H, W, 4), red first.
    """
    order = cv2.COLOR_RGBA2BGRA if image.shape[2] == 4 else cv2.COLOR_RGB2BGR
    done, encoded = cv2.imencode(
        ".png", cv2.cvtColor(image, order), [cv2.IMWRITE_PNG_COMPRESSION, 1]
    )
    if not done:
        raise ValueError(f"cannot encode an image of shape {image.shape}")
    return bytes(encoded.tobytes())


def data_uri(image: npt.NDArray[np.uint8]) -> str:
    """A picture uint8 (H, W, 3 or 4) as the ``src`` of an ``<img>``."""
    return "data:image/png;base64," + base64.b64encode(png_bytes(image)).decode("ascii")
