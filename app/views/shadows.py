"""Soft contact shadows: a sheet under each block that moves with it, over draped fields too."""

import math
from typing import Any

import cv2
import numpy as np
import numpy.typing as npt
import trimesh
import viser
from PIL import Image
from trimesh.exchange.gltf import export_glb
from trimesh.visual import TextureVisuals
from trimesh.visual.material import PBRMaterial

from singulate.geometry import BlockPose, Poses

_PIXELS = 64
_REACH = 0.85
"""Half the side of a sheet, in sides of the block."""
_DARKNESS = 0.55
_BLUR = 0.11
"""Standard deviation of the soft edge, in sides of the block."""
_OFFSET_M = (0.008, -0.008)
"""The light comes from the left and the back, so shadows lie a little to the front right."""
_HEIGHT = 0.003
ORIGIN_HEIGHT = 3.0
"""Browsers draw transparent things in the order of their origins' distance from the camera, so a
shadow's origin is high above the table: it is drawn after the field that it falls on [m]."""


class ShadowsView:
    """The shadows of all blocks; handles are made once and then only moved.

    Args:
        scene: Where they are drawn.
    """

    def __init__(self, scene: viser.SceneApi) -> None:
        self._scene = scene
        self._sheet = shadow_glb()
        self._handles: list[viser.GlbHandle] = []

    def update(self, poses: Poses) -> None:
        """Show the shadows of these blocks."""
        for index in range(len(self._handles), len(poses)):
            self._handles.append(self._add(index))
        for index, handle in enumerate(self._handles):
            _place(handle, poses[index] if index < len(poses) else None)

    def _add(self, index: int) -> viser.GlbHandle:
        return self._scene.add_glb(
            f"/shadows/{index}",
            self._sheet,
            visible=False,
            cast_shadow=False,
            receive_shadow=False,
        )


def shadow() -> npt.NDArray[np.uint8]:
    """Picture of the shadow of a block of side 1 in the middle of a sheet of side 2 * 0.85.

    Returns:
        RGBA uint8 (H, W, 4), black and more or less transparent.
    """
    centres = (np.arange(_PIXELS) + 0.5) / _PIXELS * 2 * _REACH - _REACH
    pixel = 2 * _REACH / _PIXELS
    covered = np.clip((0.5 - np.abs(centres)) / pixel + 0.5, 0.0, 1.0)
    alpha = cv2.GaussianBlur(np.outer(covered, covered), (0, 0), _BLUR / pixel)
    picture = np.zeros((_PIXELS, _PIXELS, 4), dtype=np.uint8)
    picture[..., 3] = np.round(255 * _DARKNESS * alpha)
    return picture


def shadow_glb() -> bytes:
    """The sheet as a GLB file: horizontal, `ORIGIN_HEIGHT` below its origin."""
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    material = PBRMaterial(  # type: ignore[no-untyped-call]
        baseColorTexture=Image.fromarray(shadow()),
        alphaMode="BLEND",
        metallicFactor=0.0,
        roughnessFactor=1.0,
    )
    sheet = trimesh.Trimesh(
        np.insert(corners * _REACH, 2, -ORIGIN_HEIGHT, axis=1),
        [[0, 1, 2], [0, 2, 3]],
        visual=TextureVisuals(uv=(corners + 1) / 2, material=material),  # type: ignore[no-untyped-call]
        process=False,
    )
    glb = export_glb(trimesh.Scene(sheet), tree_postprocessor=_draw_without_light)  # type: ignore[no-untyped-call]
    return bytes(glb)


def _draw_without_light(gltf: dict[str, Any]) -> None:
    """A shadow is as dark in any light, and cheaper: browsers compile and draw less."""
    gltf["extensionsUsed"] = ["KHR_materials_unlit"]
    for material in gltf["materials"]:
        material["extensions"] = {"KHR_materials_unlit": {}}


def _place(handle: viser.GlbHandle, pose: BlockPose | None) -> None:
    if pose is not None:
        x, y = (at + shift for at, shift in zip(pose.position[:2], _OFFSET_M, strict=True))
        handle.position = (x, y, _HEIGHT + ORIGIN_HEIGHT)
        handle.wxyz = (math.cos(pose.yaw / 2), 0.0, 0.0, math.sin(pose.yaw / 2))
        if handle.scale != (pose.side, pose.side, 1.0):
            handle.scale = (pose.side, pose.side, 1.0)
    if handle.visible != (pose is not None):
        handle.visible = pose is not None
