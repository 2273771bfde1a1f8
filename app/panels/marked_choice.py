"""A choice of few, as buttons of which one is marked.

Unlike checkboxes and drop-down lists, buttons leave the page's keys working after a click: the
browser gives no keys to the page while an input field has the focus.
"""

from collections.abc import Callable, Sequence

import viser

from app.panels.listening import on_pick


class MarkedChoice:
    """A row of buttons; the marked one is the present state.

    Args:
        gui: Where it is added.
        label: Text beside it.
        options: Texts of the buttons where they are not chosen.
        chosen: Texts of the same buttons where they are.
        act: Called with the index of a pressed button.
        hint: Shown on hover.
    """

    def __init__(
        self,
        gui: viser.GuiApi,
        label: str,
        options: Sequence[str],
        chosen: Sequence[str],
        act: Callable[[int], None],
        hint: str | None = None,
    ) -> None:
        self._options, self._chosen = tuple(options), tuple(chosen)
        self._index: int | None = None
        self.handle = gui.add_button_group(label, self._options, hint=hint)
        on_pick(self.handle, act)

    def show(self, index: int) -> None:
        """Mark a button."""
        if index != self._index:
            self._index = index
            self.handle.options = tuple(
                self._chosen[i] if i == index else option for i, option in enumerate(self._options)
            )


def add_switch(
    gui: viser.GuiApi,
    label: str,
    act: Callable[[bool], None],
    words: tuple[str, str] = ("on", "off"),
    hint: str | None = None,
) -> MarkedChoice:
    """A choice between two; `act` gets True for the first, ``show(0)`` marks it."""
    return MarkedChoice(
        gui,
        label,
        [f"○ {word}" for word in words],
        [f"● {word}" for word in words],
        lambda index: act(index == 0),
        hint,
    )
