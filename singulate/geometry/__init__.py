"""Plain values that every layer shares: the workspace, pushes, blocks and camera frames."""

from singulate.geometry.block import (
    Block,
    BlockPose,
    Layout,
    Poses,
    layout_to_dicts,
    parse_layout,
    standing_pose,
)
from singulate.geometry.camera_frame import CameraFrame
from singulate.geometry.direction import Direction
from singulate.geometry.push import Push
from singulate.geometry.workspace import Workspace

__all__ = [
    "Block",
    "BlockPose",
    "CameraFrame",
    "Direction",
    "Layout",
    "Poses",
    "Push",
    "Workspace",
    "layout_to_dicts",
    "parse_layout",
    "standing_pose",
]
