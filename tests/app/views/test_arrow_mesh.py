"""The arrow's mesh: a closed plate without a bottom, as long as it says."""

import numpy as np
import pytest
import trimesh

from app.views.arrow_mesh import ArrowShape

SHAPE = ArrowShape(0.01)


@pytest.mark.parametrize("length", [0.5, 0.2, 0.03])
def test_it_reaches_from_the_origin_to_its_tip(length: float) -> None:
    vertices = SHAPE.vertices(length)
    assert vertices[:, 0].min() == 0.0
    assert vertices[:, 0].max() == pytest.approx(length)
    tip = vertices[vertices[:, 0].argmax()]
    assert tip[1] == 0.0
    assert vertices[:, 2].max() == 0.0
    assert np.allclose(vertices[:, 1].max(), -vertices[:, 1].min())


def test_its_faces_look_outwards() -> None:
    mesh = trimesh.Trimesh(SHAPE.vertices(0.5), SHAPE.faces(), process=False)
    up = mesh.face_normals[:, 2] > 0.5
    shaft, head = 0.5 - 0.07, 0.07
    assert mesh.area_faces[up].sum() == pytest.approx(0.02 * shaft + 0.064 * head / 2)
    outwards = mesh.triangles_center[~up] - (0.45, 0.0, 0.0)
    is_long_side = np.abs(mesh.face_normals[~up][:, 1]) > 0.5
    facing = (outwards * mesh.face_normals[~up]).sum(axis=1)
    assert is_long_side.sum() >= 8
    assert (facing[is_long_side] > 0.0).all()
