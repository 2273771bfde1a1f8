import numpy as np

from app.fields.catalogue import FIELDS_BY_KEY
from app.panels.montage import montage_html
from singulate.geometry import Direction

KIND = FIELDS_BY_KEY["reward"]


def test_four_pictures_in_the_papers_order_with_one_ring_on_the_best_push():
    stack = np.zeros((4, 8, 8), np.float32)
    stack[Direction.DOWN, 0, 0] = 5.0
    html = montage_html(KIND, stack, ((0.0, 5.0),) * 4, has_legend=True)
    assert html.count("<img") == 4
    places = [html.index(name) for name in ("↑ up", "→ right", "↓ down", "← left")]
    assert places == sorted(places)
    assert html.count("border-radius:50%") == 1
    assert places[1] < html.index("top:6.2%;left:6.2%") < places[2]
    assert html.count("singulate-legend") == 1


def test_with_ranges_of_their_own_each_picture_has_its_legend():
    stack = np.ones((4, 8, 8), np.float32)
    html = montage_html(KIND, stack, ((0.0, 1.0),) * 4, has_legend=False)
    assert html.count("singulate-legend") == 4


def test_maps_without_any_value_are_drawn_without_a_ring():
    stack = np.full((4, 8, 8), np.nan, np.float32)
    html = montage_html(KIND, stack, ((0.0, 1.0),) * 4, has_legend=True)
    assert html.count("<img") == 4
    assert "border-radius:50%" not in html
