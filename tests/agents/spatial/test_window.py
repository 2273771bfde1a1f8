import numpy as np
import pytest
import torch

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.network import ValueNetwork
from singulate.agents.spatial.value_map import value_maps
from singulate.agents.spatial.window import cut_windows, mirror_each, read_between


def _value(network: ValueNetwork, image: FloatMap, pixel: tuple[float, float]) -> float:
    windows = cut_windows(image[None], np.array([pixel]), rng=None)
    with torch.no_grad():
        cells = network(torch.from_numpy(windows.canvases))
    return float(read_between(cells, torch.from_numpy(windows.pixels)))


@pytest.mark.parametrize("pixel", [(33.25, 29.75), (1.0, 1.5), (61.5, 57.0), (29.9, 61.1)])
def test_a_window_gives_what_the_whole_picture_gives(
    network: ValueNetwork, image: FloatMap, pixel: tuple[float, float]
) -> None:
    """At pixels that lie in their cell as `cut_windows` puts them."""
    whole = torch.from_numpy(value_maps(network, image[None]))
    expected = read_between(whole, torch.tensor([pixel]))
    assert _value(network, image, pixel) == pytest.approx(float(expected), abs=1e-6)


@pytest.mark.parametrize("pixel", [(-0.5, -0.5), (63.5, 63.5), (63.0, 0.0)])
def test_starts_on_the_edge_of_the_table_have_values(
    network: ValueNetwork, image: FloatMap, pixel: tuple[float, float]
) -> None:
    inside = (min(max(pixel[0], 0.0), 63.0), min(max(pixel[1], 0.0), 63.0))
    assert _value(network, image, pixel) == _value(network, image, inside)


def test_places_in_the_cell_vary_but_show_the_same_start(image: FloatMap) -> None:
    pixels = np.full((200, 2), (26.25, 35.5))
    windows = cut_windows(np.stack([image] * 200), pixels, np.random.default_rng(0))
    whole = windows.pixels.astype(int)
    assert {tuple(place) for place in whole} == {(a, b) for a in range(3) for b in range(3)}
    assert np.allclose(windows.pixels - whole, (0.25, 0.5))
    start_values = windows.canvases[np.arange(200), 24 + whole[:, 0], 16 + whole[:, 1]]
    assert (start_values == image[26, 35]).all()


def test_values_between_pixels_are_bilinear() -> None:
    values = torch.tensor([[[0.0, 1.0], [2.0, 5.0]]])
    pixels = torch.tensor([[0.5, 0.25]])
    assert float(read_between(values, pixels)) == pytest.approx(0.5 * 0.25 + 0.5 * 2.75)
    assert float(read_between(values, torch.tensor([[1.0, 1.0]]))) == 5.0


def test_mirroring_moves_the_start_with_the_picture(image: FloatMap) -> None:
    maps, pixels = np.stack([image, image]), np.array([[30.0, 34.0], [30.0, 34.0]])
    mirrored, moved = mirror_each(maps, pixels, np.array([False, True]))
    assert np.array_equal(mirrored[0], image)
    assert np.array_equal(mirrored[1], image[:, ::-1])
    assert moved.tolist() == [[30.0, 34.0], [30.0, 29.0]]
