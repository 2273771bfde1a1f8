"""What every panel of one client's page shares."""

from collections.abc import Callable
from dataclasses import dataclass, field

import viser

from app.commands import Command
from app.panels.secondary import SecondaryButtons
from app.preferences import Preferences
from singulate.geometry import Workspace


@dataclass(frozen=True)
class PanelContext:
    """Handed to every panel.

    Attributes:
        gui: Where widgets are added: a client's own, or a server's in tests.
        submit: Takes commands to the laboratory; returns at once.
        preferences: This client's choices.
        report: Tells this client alone that a value was not accepted.
        secondary: Makes quiet buttons.
        name: What the others call this client's person.
        workspace: The table.
    """

    gui: viser.GuiApi
    submit: Callable[[Command], None]
    preferences: Preferences
    report: Callable[[str], None]
    secondary: SecondaryButtons
    name: str = ""
    workspace: Workspace = field(default_factory=Workspace)
