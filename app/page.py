"""One client's page: panels, keys and choices, fed with snapshots by the main loop."""

import time
from collections.abc import Callable
from dataclasses import replace

import viser
from viser._gui_handles import GuiModalHandle

from app.commands import AgentPush, Command, Undo
from app.fields.catalogue import FIELDS_BY_KEY, computed_fields
from app.fields.drape import drape, ingredients
from app.fields.draped import DrapedField
from app.fields.inline_image import png_bytes
from app.keys import bind_keys
from app.panels.context import PanelContext
from app.panels.fields import FieldsPanel
from app.panels.help import HELP_TEXT
from app.panels.interact import InteractPanel
from app.panels.marked_choice import add_switch
from app.panels.notices import NoticesView
from app.panels.paper import PaperPanel
from app.panels.run import RunPanel
from app.panels.secondary import SecondaryButtons
from app.panels.sight import FIELDS, STARTS, TABLE, TRAINING, Sight
from app.panels.starts import StartsPanel
from app.panels.table_legend import TableLegend
from app.panels.training import TrainingPanel
from app.panels.watch import Throttle, Watch
from app.preferences import Preferences
from app.remembered import Remembered
from app.snapshot import Snapshot
from singulate.geometry import Direction, Workspace

LEFT_WIDTH, RIGHT_WIDTH = 264, 360
BRAND = (30, 110, 186)
DRAPE_INTERVAL = 0.05
"""Shortest time between two pictures on the table [s]."""
PICTURE_SIZE = (1080, 1920)


class ClientPage:
    """Everything beside the table for one browser.

    Args:
        client: The browser's connection.
        submit: Takes commands to the laboratory; returns at once.
        name: What the others call this person.

    Attributes:
        preferences: This client's choices.
    """

    def __init__(
        self, client: viser.ClientHandle, submit: Callable[[Command], None], name: str = ""
    ) -> None:
        self._client, self._submit = client, submit
        self.preferences = Preferences()
        self._workspace = Workspace()
        self._draped: DrapedField | None = None
        self._help: GuiModalHandle | None = None
        self._drape_watch, self._drape_throttle = Watch(), Throttle(DRAPE_INTERVAL)
        self._is_drape_old = True
        self._secondary = SecondaryButtons(client.gui, self.preferences.is_dark)
        self._context = PanelContext(
            client.gui, submit, self.preferences, self._report, self._secondary, name
        )
        self._theme_watch = Watch()
        self._sight = Sight(client, self._report)
        with client.atomic():
            self._add_left()
            self._add_right()
        self._update_theme()
        self._bind_keys()
        self._remembered = Remembered(client, self.preferences)

    def _add_left(self) -> None:
        gui = self._client.gui
        gui.set_panel_label("singulate")
        gui.main_panel.dock_left()
        gui.main_panel.set_width(LEFT_WIDTH)
        self._notices = NoticesView(self._context)
        self._run = RunPanel(self._context)
        self._theme = add_switch(gui, "Theme", self._set_light, ("light", "dark"))
        self._legend = TableLegend(self._context)

    def _add_right(self) -> None:
        panel = self._client.gui.add_panel()
        with panel.add_tab("Interact"):
            self._interact = InteractPanel(self._context)
        with panel.add_tab("Fields"):
            self._sight.mark(FIELDS)
            self._fields = FieldsPanel(self._context)
        with panel.add_tab("Training"):
            self._sight.mark(TRAINING)
            self._training = TrainingPanel(self._context)
        with panel.add_tab("Starts"):
            self._sight.mark(STARTS)
            self._starts = StartsPanel(self._context)
        with panel.add_tab("Paper"):
            PaperPanel(self._context)
        panel.dock_right()
        panel.set_width(RIGHT_WIDTH)

    def _bind_keys(self) -> None:
        interact, fields = self._interact, self._fields
        bind_keys(
            self._client.gui,
            (
                ("space", "Pause the scene", interact.pause_or_go),
                ("N", "One step", interact.step),
                ("R", "Reset the scene", interact.reset),
                ("Z", "Undo", lambda: self._submit(Undo())),
                ("1", "Next push up", lambda: self.set_direction(Direction.UP)),
                ("2", "Next push right", lambda: self.set_direction(Direction.RIGHT)),
                ("3", "Next push down", lambda: self.set_direction(Direction.DOWN)),
                ("4", "Next push left", lambda: self.set_direction(Direction.LEFT)),
                ("P", "Let the agent push", lambda: self._submit(AgentPush())),
                ("T", "Train or pause", self._run.train_or_pause),
                ("F", "Next field", lambda: fields.turn_page(1)),
                ("G", "Previous field", lambda: fields.turn_page(-1)),
                ("X", "Save a picture", self._save_picture),
                ("H", "Help", self._show_help),
            ),
            self._report,
        )

    @property
    def draped(self) -> DrapedField | None:
        """The field on this client's table; the same object until something about it changes."""
        return self._draped

    @property
    def wanted_fields(self) -> frozenset[str]:
        """What has to be computed for this client's view."""
        if not self._sight.shows(TABLE):
            return frozenset()
        return computed_fields(self.preferences, self._sight.shows(FIELDS))

    @property
    def direction(self) -> Direction:
        """Direction of the next clicked push."""
        return self.preferences.direction

    def set_direction(self, direction: Direction) -> None:
        """Choose the direction of the next clicked push."""
        self.preferences.direction = direction

    def choose_block(self, index: int) -> None:
        """Let the buttons for blocks take this one."""
        self._interact.blocks.chosen = index

    @property
    def is_dark(self) -> bool:
        """Whether this client chose the dark theme."""
        return self.preferences.is_dark

    def inspect(self, xy: tuple[float, float]) -> bool:
        """List true and predicted values of all directions at a clicked place on the table [m].

        Returns:
            Whether the click was for inspection; if not, nothing happens and it may push.
        """
        if self.preferences.click_inspects:
            self.preferences.inspected = xy
        return self.preferences.click_inspects

    def update(self, snapshot: Snapshot) -> None:
        """Show a snapshot; cheap where nothing changed."""
        now = time.monotonic()
        self._remembered.update()
        self._update_theme()
        self._notices.update(snapshot)
        self._run.update(snapshot)
        self._interact.update(snapshot)
        if self._sight.shows(TABLE):
            self._update_draped(snapshot, now)
            if not self._is_drape_old:
                self._legend.update(snapshot, self._draped)
        if self._sight.shows(FIELDS):
            self._fields.update(snapshot, now)
        if self._sight.shows(TRAINING):
            self._training.update(snapshot, now)
        if self._sight.shows(STARTS):
            self._starts.update(snapshot, now)

    def close(self) -> None:
        """Let go of what was last drawn; viser drops the widgets with the connection."""
        self._draped = None

    def _update_draped(self, snapshot: Snapshot, now: float) -> None:
        choices = replace(self.preferences, inspected=None)
        kind = FIELDS_BY_KEY[choices.field]
        self._is_drape_old |= self._drape_watch.has_changed(choices, *ingredients(snapshot, kind))
        if self._is_drape_old and self._drape_throttle.is_due(now):
            self._is_drape_old = False
            self._draped = drape(snapshot, choices, self._workspace)

    def _set_light(self, is_light: bool) -> None:
        self.preferences.is_dark = not is_light

    def _update_theme(self) -> None:
        if not self._theme_watch.has_changed(self.preferences.is_dark):
            return
        self._theme.show(int(self.preferences.is_dark))
        self._secondary.paint(self.preferences.is_dark)
        self._client.gui.configure_theme(
            dark_mode=self.preferences.is_dark,
            show_logo=False,
            show_share_button=False,
            brand_color=BRAND,
        )

    def _report(self, text: str) -> None:
        self._client.add_notification("Not accepted", text, auto_close_seconds=6.0, color="red")

    def _save_picture(self) -> None:
        height, width = PICTURE_SIZE
        image = self._client.get_render(height=height, width=width)
        self._client.send_file_download("singulate.png", png_bytes(image), save_immediately=True)

    def _show_help(self) -> None:
        if self._help is not None and not self._help.closed:
            self._help.close()
            return
        self._help = modal = self._client.gui.add_modal("Keys")
        with modal:
            self._client.gui.add_markdown(HELP_TEXT)
            close = self._client.gui.add_button("Close")
        close.on_click(lambda _: modal.close())
