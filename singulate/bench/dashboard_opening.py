"""How soon a page that is opened shows what it is for."""

from pathlib import Path
from typing import NamedTuple

from singulate.bench.dashboard_page import open_window

_TIMEOUT_MS = 60_000

_WATCH = """() => {
    const isDrawn = (name) => {
        let isFound = false;
        window.__viserMutable?.nodeRefFromName?.[name]?.traverse((part) => {
            const {map} = part.material ?? {};
            isFound ||= part.isMesh && part.visible && (!map || map.image?.width > 2);
        });
        return isFound;
    };
    new PerformanceObserver((list) => {
        for (const {element, startTime} of list.getEntries()) {
            if (element?.matches("#first-look img")) window.__shownAt = startTime;
        }
    }).observe({type: "largest-contentful-paint", buffered: true});
    const look = () => {
        if (["/blocks/0", "/field"].every(isDrawn)) {
            requestAnimationFrame(() => { window.__drawnAt = performance.now(); });
        } else {
            requestAnimationFrame(look);
        }
    };
    requestAnimationFrame(look);
}"""
"""A field that has not come yet is a picture of 2 pixels. Of the first look, the picture that takes
the most room counts, when it is painted: that of the table."""


class OpeningTimes(NamedTuple):
    """Seconds from the begin of a navigation.

    Attributes:
        first_look: Until pictures of the scene and its maps have been shown; NaN where a page has
            none.
        drawn: Until the live scene with its field has been drawn.
    """

    first_look: float
    drawn: float


def time_opening(url: str, directory: Path) -> OpeningTimes:
    """Open a page in a browser that has seen none before.

    Args:
        url: Where the dashboard listens.
        directory: For a small file that starts the browser.

    Raises:
        SingulateError: If playwright or a browser is missing, or the page does not answer.
    """
    with open_window(directory) as window:
        window.add_init_script(f"({_WATCH})()")
        window.goto(url)
        window.wait_for_function("() => window.__drawnAt > 0", timeout=_TIMEOUT_MS)
        shown, drawn = window.evaluate("() => [window.__shownAt ?? NaN, window.__drawnAt]")
        return OpeningTimes(float(shown) / 1e3, float(drawn) / 1e3)
