import numpy as np

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.exploration import NEAR, aimed_push
from singulate.geometry import Direction, Workspace

WORKSPACE = Workspace()


def test_aimed_pushes_start_near_objects_and_meet_them(image: FloatMap) -> None:
    rng = np.random.default_rng(0)
    pushes = [aimed_push(image, WORKSPACE, rng) for _ in range(300)]
    assert {push.nearest_direction for push in pushes} == set(Direction)
    assert len({push.start for push in pushes}) == 300
    for push in pushes:
        start = WORKSPACE.xy_to_row_col(*push.start)
        assert 0.0 < image[start] * WORKSPACE.metres_per_pixel <= NEAR
        steps = np.linspace(0.0, 1.0, 100)[:, None]
        path = np.array(push.start) + steps * (np.array(push.end) - np.array(push.start))
        assert min(image[WORKSPACE.xy_to_row_col(*point)] for point in path) < 0.0


def test_without_objects_pushes_are_anywhere() -> None:
    nothing = np.full((64, 64), 90.5, dtype=np.float32)
    rng = np.random.default_rng(0)
    starts = np.array([aimed_push(nothing, WORKSPACE, rng).start for _ in range(300)])
    assert (np.abs(starts) <= 1.0).all()
    assert (starts.std(axis=0) > 0.5).all()
