"""One client's page on a server of its own, fed with scripted snapshots."""

import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, field, replace
from typing import Any

import pytest
import viser
from PIL import Image
from playwright.sync_api import Browser, Download, Page

from app.commands import (
    AgentPush,
    Command,
    PauseTraining,
    ResetScene,
    SetScenePaused,
    SetSpeed,
    SetWatching,
    StepScene,
    Undo,
)
from app.page import PICTURE_SIZE, ClientPage
from app.preferences import Preferences
from app.snapshot import Snapshot
from singulate.geometry import Direction

pytestmark = pytest.mark.browser


@dataclass
class Stage:
    """A browser window and the page that the server keeps for it."""

    window: Page
    server: viser.ViserServer
    snapshot: Snapshot
    submitted: list[Command] = field(default_factory=list)
    page: ClientPage | None = None
    client_id: int = -1

    def until(self, condition: Callable[[], object], timeout_s: float = 20.0) -> None:
        deadline = time.monotonic() + timeout_s
        while not condition():
            assert time.monotonic() < deadline, f"did not happen; submitted: {self.submitted}"
            self.play()

    def play(self, duration_s: float = 0.1) -> None:
        for client_id, client in self.server.get_clients().items():
            if client_id != self.client_id:
                self.client_id = client_id
                self.page = ClientPage(client, self.submitted.append)
        if self.page is not None and self.client_id in self.server.get_clients():
            self.page.update(self.snapshot)
        self.window.wait_for_timeout(1000.0 * duration_s)

    def says(self, text: str) -> bool:
        return text in self.window.inner_text("body")

    def send(self, handle: Any, value: object) -> None:
        """What a browser that does not keep to the rules would send."""
        self.window.evaluate(
            "([uuid, value]) => window.__viserMutable.sendMessage("
            "{type: 'GuiUpdateMessage', uuid: uuid, updates: {value: value}})",
            [handle._impl.uuid, value],
        )


@pytest.fixture(scope="module")
def open_stage(browser: Browser) -> Iterator[Stage]:
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    context = browser.new_context(viewport={"width": 1280, "height": 720})
    stage = Stage(context.new_page(), server, Snapshot(None, None, None, None))
    stage.window.goto(f"http://127.0.0.1:{server.get_port()}")
    stage.until(lambda: stage.page is not None and stage.says("Push towards"))
    yield stage
    context.close()
    server.stop()


@pytest.fixture
def stage(open_stage: Stage, make_snapshot: Callable[..., Snapshot]) -> Stage:
    """The page as it was opened, whatever was chosen on it before."""
    assert open_stage.page is not None
    open_stage.snapshot = make_snapshot()
    open_stage.submitted.clear()
    for name, value in asdict(Preferences()).items():
        setattr(open_stage.page.preferences, name, value)
    open_stage.window.get_by_role("tab", name="Interact").click()
    open_stage.window.evaluate("() => document.activeElement?.blur()")
    open_stage.play(0.4)
    return open_stage


def test_keys_command_and_choose(stage: Stage) -> None:
    assert stage.page is not None
    for key in ("Space", "n", "r", "z", "p", "t"):
        stage.window.keyboard.press(key)
        stage.play()
    expected = [
        SetScenePaused(True), SetScenePaused(True), StepScene(), ResetScene("random-2", 7),
        Undo(), AgentPush(), PauseTraining(),
    ]  # fmt: skip
    stage.until(lambda: len(stage.submitted) >= len(expected))
    assert stage.submitted == expected
    for key, direction in zip("1234", Direction, strict=True):
        stage.window.keyboard.press(key)
        stage.until(lambda direction=direction: stage.page.direction == direction)  # type: ignore[union-attr,misc]
    stage.window.keyboard.press("f")
    stage.until(lambda: stage.page.preferences.field == "q")  # type: ignore[union-attr]
    stage.window.keyboard.press("g")
    stage.until(lambda: stage.page.preferences.field == "reward")  # type: ignore[union-attr]
    stage.window.keyboard.press("h")
    stage.until(lambda: stage.says("let the agent push"))
    stage.window.keyboard.press("h")
    stage.until(lambda: not stage.says("let the agent push"))


def test_buttons_do_what_keys_do(stage: Stage) -> None:
    for name in ("Undo", "Agent pushes", "Pause"):
        stage.window.get_by_role("button", name=name, exact=True).first.click()
        stage.play()
    stage.window.get_by_role("button", name="○ on").first.click()
    expected = [Undo(), AgentPush(), PauseTraining(), SetWatching(True)]
    stage.until(lambda: len(stage.submitted) >= len(expected))
    assert stage.submitted == expected


def test_values_that_the_page_never_sends_change_nothing(stage: Stage) -> None:
    assert stage.page is not None
    interact = stage.page._interact
    for handle, value in (
        (interact.speed, 1e9),
        (interact.speed, -1.0),
        (interact.seed, -5),
        (interact.scenario, "mars"),
    ):
        before = handle.value
        stage.send(handle, value)
        stage.until(lambda: stage.says("is not allowed"))
        stage.until(lambda handle=handle, before=before: handle.value == before)  # type: ignore[misc]
    assert stage.submitted == []
    stage.send(interact.speed, 2.0)
    stage.until(lambda: stage.submitted == [SetSpeed(2.0)])


def test_choices_survive_a_reload_and_the_theme_is_drawn(stage: Stage) -> None:
    assert stage.page is not None
    stage.play(0.5)
    stage.window.keyboard.press("g")
    stage.window.get_by_role("button", name="dark").first.click()
    dark = "() => document.documentElement.dataset.mantineColorScheme === 'dark'"
    stage.until(lambda: stage.window.evaluate(dark))
    stage.until(lambda: stage.page.preferences.field == "camera")  # type: ignore[union-attr]
    stage.play(0.5)
    first = stage.client_id
    stage.window.reload()
    stage.until(lambda: stage.client_id != first)
    stage.until(lambda: stage.page.is_dark and stage.page.preferences.field == "camera")  # type: ignore[union-attr]
    stage.until(lambda: stage.window.evaluate(dark))
    stage.window.get_by_role("button", name="light").first.click()
    stage.until(lambda: not stage.window.evaluate(dark))
    stage.play(0.5)


def test_an_update_without_news_is_cheap_and_leaves_the_picture_alone(
    stage: Stage, pace: float
) -> None:
    page = stage.page
    assert page is not None
    stage.play(0.5)
    draped = page.draped
    assert draped is not None
    costs = []
    for _ in range(100):
        start = time.perf_counter()
        page.update(stage.snapshot)
        costs.append(time.perf_counter() - start)
    assert statistics.median(costs) < 0.002 * pace
    assert page.draped is draped
    page.preferences.field = "none"
    assert page.wanted_fields == set()
    stage.until(lambda: page.draped is None)


def test_only_what_can_be_seen_is_wanted_and_drawn(stage: Stage) -> None:
    page = stage.page
    assert page is not None
    stage.until(lambda: page.wanted_fields == {"reward_map"})
    before = page._fields.q.content
    policy = stage.snapshot.policy
    assert policy is not None and policy.q_map is not None
    stage.snapshot = replace(stage.snapshot, policy=replace(policy, q_map=policy.q_map + 1.0))
    stage.play(0.5)
    assert page._fields.q.content == before

    stage.window.get_by_role("tab", name="Fields").click()
    stage.until(lambda: page.wanted_fields == {"reward_map", "q_map", "start_density"})
    stage.until(lambda: page._fields.q.content != before)
    page.preferences.shows_all_directions = False
    assert page.wanted_fields == {"reward_map"}

    look_away = "Object.defineProperty(document, 'hidden', {configurable: true, value: true})"
    stage.window.evaluate(look_away)
    stage.until(lambda: page.wanted_fields == set())
    stage.window.evaluate("delete document.hidden")
    stage.window.get_by_role("tab", name="Interact").click()
    stage.until(lambda: page.wanted_fields == {"reward_map"})
    stage.send(page._sight._carrier, "table moon")
    stage.until(lambda: stage.says("is not allowed"))
    assert page.wanted_fields == {"reward_map"}


def test_a_click_inspects_only_where_it_was_asked_to(stage: Stage) -> None:
    page = stage.page
    assert page is not None
    assert not page.inspect((0.1, 0.2))
    stage.window.get_by_role("tab", name="Fields").click()
    stage.window.get_by_role("button", name="inspects").click()
    stage.until(lambda: page.preferences.click_inspects)
    assert page.inspect((0.5, 0.5))
    stage.until(lambda: stage.says("Inspect (0.50, 0.50) m"))


def test_a_picture_is_offered_as_a_download(stage: Stage) -> None:
    downloads: list[Download] = []
    stage.window.on("download", lambda download: downloads.append(download))  # not a builtin
    stage.window.keyboard.press("x")
    stage.until(lambda: downloads, timeout_s=60.0)
    (download,) = downloads
    assert download.suggested_filename == "singulate.png"
    with Image.open(download.path()) as picture:
        assert (picture.height, picture.width) == PICTURE_SIZE
