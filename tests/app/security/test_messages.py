"""What a browser may send: raw websockets against real inputs of a real server."""

import math
from collections.abc import Callable
from typing import Any

import msgspec.msgpack
import pytest
import viser
from viser import _messages
from websockets.exceptions import ConnectionClosedError

from app.choices import MAX_SEED
from app.security import is_acceptable
from app.server import MAX_MESSAGE_BYTES

Send = Callable[[Any, dict[str, Any]], None]
Eventually = Callable[[Callable[[], object]], None]


def update(handle: Any, **updates: object) -> dict[str, Any]:
    return {"type": "GuiUpdateMessage", "uuid": handle._impl.uuid, "updates": updates}


@pytest.mark.parametrize("value", [1e9, -1.0, math.nan, math.inf, "5", None, [5.0], True])
def test_a_slider_takes_only_numbers_in_its_range(
    door: Any, tell: Send, eventually: Eventually, value: object
) -> None:
    slider = door.server.gui.add_slider("speed", 0.0, 10.0, 0.1, 1.0)
    browser = door.enter()
    tell(browser, update(slider, value=value))
    tell(browser, update(slider, value=5.0))
    eventually(lambda: slider.value != 1.0)
    assert slider.value == 5.0


def test_every_seed_that_a_box_allows_arrives(
    door: Any, tell: Send, eventually: Eventually
) -> None:
    box = door.server.gui.add_number("seed", 0, min=0, max=MAX_SEED, step=1)
    tell(door.enter(), update(box, value=MAX_SEED))
    eventually(lambda: box.value == MAX_SEED)


def test_attributes_of_a_handle_cannot_be_overwritten(
    door: Any, tell: Send, eventually: Eventually
) -> None:
    slider = door.server.gui.add_slider("speed", 0, 10, 1, 1)
    browser = door.enter()
    for name in ("update_cb", "gui_api", "removed", "props"):
        tell(browser, update(slider, **{name: "mine"}))
    tell(browser, update(slider, value=3, removed=True))
    tell(browser, update(slider, value=4))
    eventually(lambda: slider.value != 1)
    assert slider.value == 4
    assert slider._impl.update_cb == []
    assert slider._impl.removed is False


def test_a_disabled_button_cannot_be_pressed(door: Any, tell: Send, eventually: Eventually) -> None:
    presses: list[str] = []
    off = door.server.gui.add_button("off", disabled=True)
    hidden = door.server.gui.add_button("hidden", visible=False)
    on = door.server.gui.add_button("on")
    for button in (off, hidden, on):
        button.on_click(lambda event: presses.append(event.target.label))
    browser = door.enter()
    for button in (off, hidden, on):
        tell(browser, update(button, value=True))
    eventually(lambda: presses)
    assert presses == ["on"]


def test_one_browser_cannot_move_the_inputs_of_another(
    door: Any, tell: Send, eventually: Eventually
) -> None:
    sliders: dict[int, Any] = {}

    @door.server.on_client_connect
    def _(client: viser.ClientHandle) -> None:
        sliders[client.client_id] = client.gui.add_slider("own", 0, 10, 1, 1)

    first, second = door.enter(), door.enter()
    eventually(lambda: len(sliders) == 2)
    mine, other = (sliders[key] for key in sorted(sliders))
    tell(first, update(other, value=7))
    tell(first, update(mine, value=8))
    eventually(lambda: mine.value == 8)
    assert other.value == 1
    tell(second, update(other, value=9))
    eventually(lambda: other.value == 9)


def test_the_share_tunnel_cannot_be_opened(door: Any, tell: Send, eventually: Eventually) -> None:
    slider = door.server.gui.add_slider("speed", 0, 10, 1, 1)
    handlers = door.server._websock_server._incoming_handlers
    assert _messages.ShareUrlRequest not in handlers
    assert _messages.ShareUrlDisconnect not in handlers
    assert _messages.GuiUpdateMessage in handlers
    browser = door.enter()
    tell(browser, {"type": "ShareUrlRequest"})
    tell(browser, update(slider, value=2))
    eventually(lambda: slider.value == 2)
    assert door.server._share_tunnel is None


@pytest.mark.parametrize("frame", ["text", b"", b"\xc1", b"\x93\x01\x02\x03", b"\x81" * 5000])
def test_nonsense_is_dropped_and_the_page_goes_on(
    door: Any, tell: Send, eventually: Eventually, frame: str | bytes
) -> None:
    slider = door.server.gui.add_slider("speed", 0, 10, 1, 1)
    browser = door.enter()
    browser.send(frame)
    tell(browser, update(slider, value=2))
    eventually(lambda: slider.value != 1)
    assert slider.value == 2, "the connection that sent nonsense is still heard"


def test_a_huge_message_ends_the_connection(door: Any) -> None:
    browser = door.enter()
    browser.send(b"\0" * (MAX_MESSAGE_BYTES - 1))
    door.enter()
    with pytest.raises(ConnectionClosedError, match="1009"):
        browser.send(b"\0" * (MAX_MESSAGE_BYTES + 1))
        for _ in range(1000):
            browser.recv(timeout=10)


CLICK: dict[str, Any] = {
    "type": "ScenePointerMessage",
    "event_type": "click",
    "ray_origin": [0.0, 0.0, 4.0],
    "ray_direction": [0, 0, -1],
    "screen_pos": [[0.5, 0.5]],
    "modifier": None,
}


@pytest.mark.parametrize(
    ("change", "is_right"),
    [
        ({}, True),
        ({"modifier": "shift"}, True),
        ({"ray_origin": [0.0, math.nan, 4.0]}, False),
        ({"ray_origin": [0.0, 4.0]}, False),
        ({"ray_origin": "0,0,4"}, False),
        ({"ray_direction": [0.0, 0.0, 1e30]}, False),
        ({"event_type": "drop table"}, False),
        ({"modifier": "hyper"}, False),
        ({"screen_pos": 3}, False),
        ({"surprise": 1}, False),
        ({"type": "RunJavascriptMessage"}, False),
        ({"type": 7}, False),
    ],
)
def test_messages_have_to_have_their_shape(change: dict[str, Any], is_right: bool) -> None:
    raw = msgspec.msgpack.encode(CLICK | change)
    assert is_acceptable(raw, lambda uuid: None) is is_right


def test_a_missing_field_is_noticed() -> None:
    for name in set(CLICK) - {"type"}:
        rest = {key: value for key, value in CLICK.items() if key != name}
        assert not is_acceptable(msgspec.msgpack.encode(rest), lambda uuid: None)
