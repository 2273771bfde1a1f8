"""A page draws what has changed, nothing else, and with it the picture is the right one."""

from collections.abc import Callable
from typing import Any

import pytest

pytestmark = pytest.mark.browser

HELPERS = """() => {
    const viewer = window.__viserMutable;
    const gl = viewer.scene.__r3f.root.getState().gl, context = gl.getContext();
    const probe = (window.__probe = { gl, context, numDrawings: 0 });
    for (const name of ["drawElements", "drawArrays"]) {
        const draw = Object.getPrototypeOf(context)[name];
        context[name] = (...mode) => { probe.numDrawings += 1; draw.apply(context, mode); };
    }
    probe.pixels = () => {
        const { width, height } = gl.domElement;
        const copy = new OffscreenCanvas(width, height).getContext("2d");
        copy.drawImage(gl.domElement, 0, 0);
        return copy.getImageData(0, 0, width, height).data;
    };
    probe.corner = () => Array.from(probe.pixels().slice(0, 4));
    const nextFrame = () => new Promise(requestAnimationFrame);
    probe.drawWhole = async () => {
        const numDrawings = probe.numDrawings;
        gl.drawWhole();
        viewer.requestRender();
        while (probe.numDrawings === numDrawings) await nextFrame();
    };
    probe.numWrongPixels = async () => {
        const before = probe.pixels();
        await probe.drawWhole();
        const after = probe.pixels();
        let numWrong = before.length === after.length ? 0 : Infinity;
        for (let i = 0; i < after.length; i += 4) {
            numWrong += [0, 1, 2, 3].some((channel) => before[i + channel] !== after[i + channel]);
        }
        return numWrong;
    };
    probe.stain = () => {
        context.enable(context.SCISSOR_TEST);
        context.scissor(0, gl.domElement.height - 8, 8, 8);
        context.clearColor(1, 0, 1, 1);
        context.clear(context.COLOR_BUFFER_BIT);
        gl.resetState();
    };
}"""
STAIN = [255, 0, 255, 255]


def settle(page: Any) -> None:
    """Wait until nothing has been drawn for half a second."""

    def is_quiet() -> bool:
        before = page.page.evaluate("() => __probe.numDrawings")
        page.page.wait_for_timeout(500)
        return bool(page.page.evaluate("() => __probe.numDrawings") == before)

    page.wait(is_quiet)


@pytest.fixture
def probed(page: Any) -> Any:
    page.page.evaluate(HELPERS)
    settle(page)
    return page


def num_drawings(page: Any) -> int:
    return int(page.page.evaluate("() => __probe.numDrawings"))


def hold_a_block(page: Any) -> None:
    page.grab_block(0)
    page.drag_block(0, -0.5, -0.4)
    page.drag_block(0, -0.3, -0.5)


def stop_in_a_push(page: Any) -> None:
    page.press("Space")
    page.press("2")
    page.click_table(-0.7, 0.3)
    for _ in range(3):
        page.press("n")
    page.wait(lambda: page.is_pushing)


def let_a_push_end(page: Any) -> None:
    page.press("1")
    page.click_table(0.2, -0.8)
    page.wait(lambda: page.is_pushing)
    page.wait(lambda: not page.is_pushing)


def point_at(page: Any) -> None:
    for x in (-0.4, 0.1, 0.5):
        page.page.mouse.move(*page.on_screen(x, 0.6), steps=3)


def turn_the_camera(page: Any) -> None:
    mouse = page.page.mouse
    mouse.move(*page.on_screen(0.7, 0.7))
    mouse.down(button="right")
    mouse.move(*page.on_screen(0.5, 0.5), steps=4)
    mouse.up(button="right")


ACTS: dict[str, tuple[Callable[[Any], None], Callable[[Any], None]]] = {
    "a block in the hand": (hold_a_block, lambda page: page.page.mouse.up()),
    "a push half way": (stop_in_a_push, lambda page: page.press("Space")),
    "a push that is over": (let_a_push_end, lambda page: page.press("z")),
    "an aim under the pointer": (point_at, lambda page: None),
    "another field": (lambda page: page.press("f"), lambda page: page.press("g")),
    "another theme": (
        lambda page: page.page.get_by_role("button", name="dark").first.click(),
        lambda page: page.page.get_by_role("button", name="light").first.click(),
    ),
    "one block more": (
        lambda page: page.button("Add").click(),
        lambda page: page.button("Remove").click(),
    ),
    "from the top": (lambda page: page.press("c"), lambda page: page.press("c")),
    "from another side": (turn_the_camera, lambda page: page.look_from_top()),
}


@pytest.mark.parametrize("act, undo", ACTS.values(), ids=ACTS)
def test_what_is_drawn_in_parts_is_as_if_drawn_whole(
    act: Callable[[Any], None], undo: Callable[[Any], None], probed: Any
) -> None:
    before = num_drawings(probed)
    act(probed)
    settle(probed)
    assert num_drawings(probed) > before, "nothing happened"
    assert probed.page.evaluate("() => __probe.numWrongPixels()") == 0
    undo(probed)
    settle(probed)
    assert probed.page.evaluate("() => __probe.numWrongPixels()") == 0


def test_nothing_is_drawn_where_nothing_changes(probed: Any) -> None:
    probed.page.evaluate("() => __probe.drawWhole()")
    before = num_drawings(probed)
    probed.page.evaluate("() => { for (let i = 0; i < 9; i++) __viserMutable.requestRender(); }")
    probed.page.wait_for_timeout(3000)
    assert num_drawings(probed) == before


def test_a_name_that_has_gone_costs_nothing(probed: Any, open_page: Callable[[], Any]) -> None:
    other = open_page()
    other.press("2")
    other.click_table(-0.7, 0.3)
    probed.wait(lambda: probed.is_visible("/actor_name"))
    probed.wait(lambda: not probed.is_visible("/actor_name"))
    settle(probed)
    probed.page.evaluate("() => __probe.drawWhole()")
    before = num_drawings(probed)
    probed.page.evaluate("() => __viserMutable.requestRender()")
    probed.page.wait_for_timeout(1000)
    assert num_drawings(probed) == before
    other.close()


def test_a_press_of_the_mouse_draws_nothing(probed: Any) -> None:
    mouse = probed.page.mouse
    mouse.move(*probed.on_screen(-0.5, -0.6))
    settle(probed)
    probed.page.evaluate("() => __probe.drawWhole()")
    before = num_drawings(probed)
    mouse.down()
    probed.page.wait_for_timeout(300)
    assert num_drawings(probed) == before
    mouse.move(*probed.on_screen(0.5, -0.6), steps=4)
    probed.wait(lambda: num_drawings(probed) > before)
    mouse.up()


@pytest.mark.parametrize(
    "act, undo",
    [ACTS["a block in the hand"], ACTS["a push half way"]],
    ids=["a block in the hand", "a push half way"],
)
def test_only_the_surroundings_of_what_moves_are_drawn(
    act: Callable[[Any], None], undo: Callable[[Any], None], probed: Any
) -> None:
    probed.page.evaluate("() => __probe.drawWhole()")
    probed.page.evaluate("() => __probe.stain()")
    act(probed)
    assert probed.page.evaluate("() => __probe.corner()") == STAIN
    probed.page.evaluate("() => __probe.drawWhole()")
    assert probed.page.evaluate("() => __probe.corner()") != STAIN
    undo(probed)


def test_what_was_overlooked_is_drawn_within_ten_seconds(probed: Any) -> None:
    probed.page.evaluate("() => __probe.drawWhole()")
    probed.page.evaluate("() => __probe.stain()")
    assert probed.page.evaluate("() => __probe.corner()") == STAIN
    probed.wait(lambda: probed.page.evaluate("() => __probe.corner()") != STAIN, timeout_s=20.0)
