"""The push of the highest value."""

import numpy as np

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.network import ValueNetwork
from singulate.agents.spatial.peak import find_peak
from singulate.agents.spatial.region import of_equal_size, starts_that_reach
from singulate.agents.spatial.turning import from_turned_pixel, turn_all_ways
from singulate.agents.spatial.value_map import FOUR_VIEWS, View, value_maps
from singulate.geometry import Direction, Push, Workspace


def best_push(
    network: ValueNetwork,
    distance_map: FloatMap,
    workspace: Workspace,
    views: tuple[View, ...] = FOUR_VIEWS,
) -> Push:
    """The push whose value, averaged over its surroundings, is highest.

    Only starts are compared from which a push can reach an object, as the picture shows it: all
    others move nothing.

    Args:
        network: The network.
        distance_map: float32 (H, H) [px], -1 inside objects.
        workspace: Gives the size of a pixel and the length of a push.
        views: What to average over.
    """
    size = len(distance_map)
    turned = turn_all_ways(distance_map)
    push_px = workspace.push_length / workspace.metres_per_pixel
    regions = of_equal_size([starts_that_reach(image, push_px) for image in turned], size)
    peaks = [find_peak(values) for values in value_maps(network, turned, views, regions)]
    best = max(Direction, key=lambda direction: peaks[direction].value)
    row, column = peaks[best].row + regions[best].row, peaks[best].column + regions[best].column
    return push_at(row, column, best, workspace)


def push_at(row: float, column: float, direction: Direction, workspace: Workspace) -> Push:
    """The push from a point of the picture that is turned for it; starts stay on the workspace."""
    half = workspace.half_length
    x, y = from_turned_pixel(row, column, direction, workspace.image_size)
    start = (float(np.clip(x, -1.0, 1.0)) * half, float(np.clip(y, -1.0, 1.0)) * half)
    return Push.cardinal(start, direction, workspace.push_length)
