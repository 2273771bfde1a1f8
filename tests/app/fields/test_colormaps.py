import numpy as np
import pytest

from app.fields.colormaps import DIVERGING, SEQUENTIAL, Colormap


def luminance(table: np.ndarray) -> np.ndarray:
    linear = (table / 255.0) ** 2.2
    return linear @ [0.2126, 0.7152, 0.0722]


def test_the_sequential_map_grows_lighter_all_the_way():
    assert (np.diff(luminance(SEQUENTIAL.table)) > -0.002).all()
    assert luminance(SEQUENTIAL.table)[-1] > 10 * luminance(SEQUENTIAL.table)[0]


def test_the_diverging_map_is_lightest_in_its_middle():
    light = luminance(DIVERGING.table)
    assert abs(int(light.argmax()) - 127.5) <= 1
    assert light[0] < 0.1 and light[-1] < 0.1


def test_the_hue_of_a_diverging_map_tells_the_sign():
    low, high = DIVERGING.table[20].astype(int), DIVERGING.table[-21].astype(int)
    assert low[2] > low[0] and high[0] > high[2]


@pytest.mark.parametrize("colormap", [SEQUENTIAL, DIVERGING])
def test_ends_are_the_first_and_last_anchor(colormap: Colormap):
    assert colormap.table.shape == (256, 3)
    for row, anchor in ((0, colormap.anchors[0]), (-1, colormap.anchors[-1])):
        assert "#" + "".join(f"{channel:02x}" for channel in colormap.table[row]) == anchor
    assert colormap.css_gradient.startswith("linear-gradient(to right, #")
