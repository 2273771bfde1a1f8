import base64

import cv2
import numpy as np
import pytest

from app.fields.inline_image import data_uri, png_bytes


@pytest.mark.parametrize("channels", [3, 4])
def test_a_picture_survives_the_journey(channels: int):
    image = np.random.default_rng(0).integers(0, 256, (5, 7, channels), dtype=np.uint8)
    flags = cv2.IMREAD_UNCHANGED
    order = cv2.COLOR_BGRA2RGBA if channels == 4 else cv2.COLOR_BGR2RGB
    decoded = cv2.imdecode(np.frombuffer(png_bytes(image), np.uint8), flags)
    assert (cv2.cvtColor(decoded, order) == image).all()


def test_data_uri_holds_the_same_bytes():
    image = np.zeros((2, 2, 3), np.uint8)
    head, text = data_uri(image).split(",")
    assert head == "data:image/png;base64"
    assert base64.b64decode(text) == png_bytes(image)
