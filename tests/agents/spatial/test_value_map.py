import numpy as np
import pytest

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.network import ValueNetwork
from singulate.agents.spatial.region import Region, of_equal_size, starts_that_reach
from singulate.agents.spatial.turning import turn_all_ways
from singulate.agents.spatial.value_map import FOUR_VIEWS, ONE_VIEW, View, value_maps
from singulate.perception import distance_map


@pytest.mark.parametrize("views", [ONE_VIEW, FOUR_VIEWS, (View(True, 3),)])
def test_regions_hold_the_values_of_the_whole(
    network: ValueNetwork, image: FloatMap, views: tuple[View, ...]
) -> None:
    turned = turn_all_ways(image)
    regions = of_equal_size([starts_that_reach(one, 16.0) for one in turned], 64)
    parts = value_maps(network, turned, views, regions)
    whole = value_maps(network, turned, views)
    assert whole.shape == (4, 64, 64)
    for region, part, full in zip(regions, parts, whole, strict=True):
        rows = slice(region.row, region.row + region.height)
        columns = slice(region.column, region.column + region.width)
        assert np.allclose(part, full[rows, columns], atol=1e-6)


def test_four_views_are_blind_to_mirrors(network: ValueNetwork, image: FloatMap) -> None:
    both = value_maps(network, np.stack([image, image[:, ::-1]]), FOUR_VIEWS)
    assert np.allclose(both[0], both[1, :, ::-1], atol=1e-6)
    one = value_maps(network, np.stack([image, image[:, ::-1]]), ONE_VIEW)
    assert not np.allclose(one[0], one[1, :, ::-1], atol=1e-4)


def test_values_move_with_the_objects(network: ValueNetwork) -> None:
    """A network of valid convolutions knows no places, but for the edge of the table."""
    masks = np.zeros((2, 64, 64), dtype=np.bool_)
    masks[0, 28:34, 30:38] = masks[1, 32:38, 26:34] = True
    maps = np.stack([distance_map(mask) for mask in masks])
    first, second = value_maps(network, maps)
    # What the network sees around these starts lies on the table in both.
    assert np.allclose(first[32:44, 28:40], second[36:48, 24:36], atol=1e-6)


def test_starts_that_reach_an_object_lie_behind_it(image: FloatMap) -> None:
    region = starts_that_reach(image, push_px=16.0)
    assert (region.row, region.column) == (20, 28)
    assert region.row + region.height >= 25 + 16 + 1
    assert region.column + region.width >= 42 + 2
    assert region.height % 4 == region.width % 4 == 0


def test_an_empty_table_leaves_all_starts() -> None:
    nothing = np.full((64, 64), 90.5, dtype=np.float32)
    assert starts_that_reach(nothing, push_px=16.0) == Region(0, 0, 64, 64)


def test_regions_of_equal_size_stay_on_the_picture() -> None:
    regions = of_equal_size([Region(40, 0, 24, 8), Region(0, 60, 8, 4)], 64)
    assert regions == [Region(40, 0, 24, 8), Region(0, 56, 24, 8)]
