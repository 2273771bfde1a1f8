"""The token, as a real browser handles it."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from app.security import AccessPolicy
from app.server import bind, open_server

pytestmark = pytest.mark.browser


@pytest.fixture
def policy() -> Iterator[AccessPolicy]:
    """A guarded server without a laboratory behind it."""
    listener = bind("127.0.0.1", 0)
    policy = AccessPolicy("127.0.0.1", listener.getsockname()[1], "a-secret-of-the-test")
    server = open_server(listener, policy)
    server.gui.add_markdown("let in")
    yield policy
    server.stop()


def test_the_printed_address_lets_a_browser_in_and_leaves_no_token_behind(
    browser: Browser, policy: AccessPolicy
) -> None:
    context = browser.new_context()
    page = context.new_page()
    refused = page.goto(f"http://127.0.0.1:{policy.port}/")
    assert refused is not None
    assert refused.status == 403
    assert "printed" in page.inner_text("body")

    page.goto(policy.url)
    page.wait_for_url(f"http://127.0.0.1:{policy.port}/")
    page.get_by_text("let in").wait_for(timeout=30_000)
    assert "token" not in page.url
    assert "singulate" not in str(page.evaluate("() => document.cookie"))
    context.close()
