"""Buttons that step back behind the main one, in light and in dark."""

import viser

LIGHT, DARK = (233, 236, 239), (55, 58, 64)


class SecondaryButtons:
    """Makes quiet buttons and recolours them with the theme."""

    def __init__(self, gui: viser.GuiApi, is_dark: bool) -> None:
        self._gui = gui
        self._colour = DARK if is_dark else LIGHT
        self._buttons: list[viser.GuiButtonHandle] = []

    def add(
        self, label: str, *, disabled: bool = False, visible: bool = True
    ) -> viser.GuiButtonHandle:
        """Add a quiet button at the present place of the page."""
        button = self._gui.add_button(label, color=self._colour, disabled=disabled, visible=visible)
        self._buttons.append(button)
        return button

    def paint(self, is_dark: bool) -> None:
        """Follow the theme."""
        self._colour = DARK if is_dark else LIGHT
        for button in self._buttons:
            button.color = self._colour
