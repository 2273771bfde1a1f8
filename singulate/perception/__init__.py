"""From camera frames to masks, distance maps, segments and their separations; arrays only."""

from singulate.perception.distance_map import distance_map
from singulate.perception.foreground import foreground_mask
from singulate.perception.inter_object_distance import (
    inter_object_distance,
    truncated_inter_object_distance,
)
from singulate.perception.percept import Percept, perceive, percept_of_mask
from singulate.perception.segmentation import Segmentation, segment
from singulate.perception.segments import label_segments
from singulate.perception.separation import segment_separations

__all__ = [
    "Percept",
    "Segmentation",
    "distance_map",
    "foreground_mask",
    "inter_object_distance",
    "label_segments",
    "perceive",
    "percept_of_mask",
    "segment",
    "segment_separations",
    "truncated_inter_object_distance",
]
