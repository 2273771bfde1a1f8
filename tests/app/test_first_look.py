"""What a page shows before viser's script has built it."""

import base64
import gzip
import re
import urllib.request

import cv2
import numpy as np
import pytest

from app.first_look import FirstLook
from app.security import AccessPolicy
from app.server import bind, open_server
from app.views.flat_table import flat_table
from singulate.geometry import Block, Workspace, standing_pose

PAGE = b"<!doctype html><html><head><title>t</title><script>x</script></head><body></body></html>"


def dressed(snapshot, page=PAGE):
    look = FirstLook(Workspace())
    if snapshot is not None:
        look.show(snapshot)
    return look.dress(page).decode()


def pictures(html):
    codes = re.findall(r"data:image/png;base64,([A-Za-z0-9+/=]+)", html)
    packed = [np.frombuffer(base64.b64decode(code), np.uint8) for code in codes]
    return [cv2.imdecode(each, cv2.IMREAD_UNCHANGED) for each in packed]


def test_it_shows_the_blocks_the_distance_map_and_what_the_agent_believes(
    make_snapshot, make_scene
):
    poses = (standing_pose(Block(x=0.3, y=0.2, yaw=0.0, side=0.2)),)
    html = dressed(make_snapshot(scene=make_scene(poses=poses)))
    table, *maps = pictures(html)
    only_blocks = flat_table(poses, None, Workspace())
    is_block = only_blocks[..., 3] == 255
    assert is_block.any()
    assert (table[..., 2::-1][is_block] == only_blocks[..., :3][is_block]).all()
    assert len(maps) == 3
    assert all(each[..., :3].std() > 1.0 for each in maps[:2])
    for text in ("Distance map", "Q of dqn-a, best direction", "Start density"):
        assert text in html
    assert html.index("first-look") < html.index("<script>x</script>")


def test_names_of_agents_are_text(make_snapshot):
    snapshot = make_snapshot()
    policy = snapshot.policy.__class__(**{**vars(snapshot.policy), "label": "<b>&"})
    html = dressed(make_snapshot(policy=policy))
    assert "<b>&" not in html
    assert "&lt;b&gt;&amp;" in html


def test_without_an_agent_there_is_the_scene_alone(make_snapshot):
    assert len(pictures(dressed(make_snapshot(policy=None)))) == 2


@pytest.mark.parametrize("shown", ["nothing", "no scene"])
def test_where_there_is_nothing_to_show_the_page_stays_as_it_is(make_snapshot, shown):
    snapshot = None if shown == "nothing" else make_snapshot(scene=None)
    assert dressed(snapshot).encode() == PAGE


def test_a_page_without_a_script_stays_as_it_is(make_snapshot):
    assert dressed(make_snapshot(), b"<html></html>") == "<html></html>"


@pytest.mark.parametrize("coding", ["identity", "gzip"])
def test_the_server_sends_it_with_visers_page(make_snapshot, coding):
    look = FirstLook(Workspace())
    look.show(make_snapshot())
    listener = bind("127.0.0.1", 0)
    policy = AccessPolicy("127.0.0.1", listener.getsockname()[1])
    server = open_server(listener, policy, dress=look.dress)
    try:
        request = urllib.request.Request(policy.url, headers={"Accept-Encoding": coding})
        with urllib.request.urlopen(request, timeout=10.0) as answer:
            body = answer.read()
            assert answer.headers["Content-Encoding"] == coding
            assert answer.headers["X-Content-Type-Options"] == "nosniff"
    finally:
        server.stop()
    html = (gzip.decompress(body) if coding == "gzip" else body).decode()
    assert len(pictures(html)) == 4
    assert html.count('<div id="root">') == 1
    assert html.index("first-look") < html.index("<script data-p=")
