from dataclasses import replace

from app.panels.inspection import inspection_html
from app.snapshot import Snapshot
from singulate.geometry import Workspace


def test_without_a_place_it_asks_for_one(make_snapshot):
    assert "Click a place" in inspection_html(make_snapshot(), None, Workspace())


def test_a_place_lists_truth_belief_and_their_difference(make_snapshot):
    html = inspection_html(make_snapshot(), (-0.72, 0.47), Workspace())
    assert "(-0.72, 0.47) m" in html
    right = html[html.index("→ right") : html.index("↓ down")]
    for text in (">1300<", ">900<", ">-400<"):
        assert text in right


def test_distance_to_the_blocks_is_told_in_metres(make_snapshot):
    assert "0.16 m from the nearest block" in inspection_html(
        make_snapshot(), (0.9, 0.9), Workspace()
    )
    assert "inside a block" in inspection_html(make_snapshot(), (0.0, 0.0), Workspace())


def test_missing_maps_leave_dashes(make_snapshot):
    snapshot = replace(make_snapshot(), policy=None, reward_map=None)
    assert inspection_html(snapshot, (0.5, 0.5), Workspace()).count("\N{EN DASH}") == 8
    empty = Snapshot(None, None, None, None)
    assert "Inspect" in inspection_html(empty, (0.5, 0.5), Workspace())
