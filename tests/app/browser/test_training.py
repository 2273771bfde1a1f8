"""Training is started and paused by button and by key, and they always agree."""

from collections.abc import Callable
from typing import Any

import pytest

pytestmark = pytest.mark.browser


def test_button_and_key_agree_in_every_window(page: Any, open_page: Callable[[], Any]) -> None:
    other = open_page()
    page.button("Start training").click()
    for window in (page, other):
        window.wait(lambda window=window: window.button("Pause").count(), 60)
    page.press("t")
    for window in (page, other):
        window.wait(lambda window=window: window.button("Resume").count(), 60)
    other.button("Resume").click()
    for window in (page, other):
        window.wait(lambda window=window: window.button("Pause").count(), 60)

    page.tab("Training")
    page.wait(lambda: page.page.locator(".uplot canvas").count() > 0, 30)
    page.picture("training")
    page.tab("Starts")
    page.wait(lambda: page.page.locator("img").count() > 0, 30)
    page.picture("starts")
    page.tab("Interact")

    other.press("t")
    page.wait(lambda: page.button("Resume").count(), 60)
    assert other.errors == []
    other.close()
