"""Training is started and paused by button and by key, and they always agree."""

from collections.abc import Callable
from typing import Any

import pytest

from app.choices import AGENTS, USUAL_PUSHES

pytestmark = pytest.mark.browser

TRAIN_BUTTON = (
    """() => [...document.querySelectorAll("button")]
    .filter((button) => button.offsetParent && button.getBoundingClientRect().right < 270)
    .map((button) => button.innerText.trim())
    .find((text) => ["Start training", "Pause", "Resume"].includes(text)) ?? """
    + '""'
)


def train_button(window: Any) -> str:
    """Text of the one button that starts and pauses, in the left panel."""
    text: str = window.page.evaluate(TRAIN_BUTTON)
    return text


def press_train_button(window: Any) -> None:
    left = window.page.get_by_role("button", name=train_button(window), exact=True)
    min(left.all(), key=lambda button: button.bounding_box()["x"]).click()


def ask_for_pushes(window: Any, number: int) -> None:
    """Fill in the form of a new run."""
    inputs = [each for each in window.page.locator("input").all() if each.is_visible()]
    pushes = [each for each in inputs if each.input_value() == str(USUAL_PUSHES[AGENTS[0]])]
    pushes[0].fill(str(number))
    pushes[0].press("Enter")


def wait_for_training(state: str, label: str, *windows: Any) -> None:
    """Until every window shows the state, and its button what can be done about it."""
    for window in windows:
        window.wait_for_text(f"{state} ·", 90)
        window.wait(lambda window=window: train_button(window) == label)


def test_button_and_key_agree_in_every_window(page: Any, open_page: Callable[[], Any]) -> None:
    other = open_page()
    assert train_button(page) == train_button(other) == "Start training"
    ask_for_pushes(page, 100_000)
    press_train_button(page)
    wait_for_training("running", "Pause", page, other)
    page.wait_for_text("100,000 pushes")

    page.press("t")
    wait_for_training("paused", "Resume", page, other)
    press_train_button(other)
    wait_for_training("running", "Pause", page, other)

    page.tab("Training")
    page.wait(lambda: page.page.locator(".uplot canvas:visible").count() > 0, 60)
    page.picture("training")
    page.tab("Starts")
    page.wait(lambda: page.page.locator("img:visible").count() > 0, 60)
    page.picture("starts")
    page.tab("Interact")

    other.press("t")
    wait_for_training("paused", "Resume", page, other)
    assert other.errors == []
    other.close()
