"""What a browser shows until viser's page is built: the table and its maps, as they stand.

viser's script needs a second or more before it draws anything, longer where no GPU helps. Its page
is therefore sent with pictures in front of it, which give way once the live table is there.
"""

from html import escape
from importlib import resources
from string import Template

from app.fields.drape import drape
from app.fields.draped import DrapedField
from app.fields.inline_image import data_uri
from app.preferences import Preferences
from app.remembered import STORAGE_KEY
from app.snapshot import Snapshot
from app.views.flat_table import flat_table
from app.views.palette import DARK, LIGHT, Colour
from singulate.geometry import Workspace

_MAPS = ("distance_map", "q", "start_density")
"""Fields beside the table, where they are there."""
_SCRIPT = b"<script"


class FirstLook:
    """Puts pictures of the latest snapshot in front of viser's page.

    Args:
        workspace: The table.
    """

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self._snapshot: Snapshot | None = None
        self._template = Template(
            resources.files("app").joinpath("assets/first_look.html").read_text()
        )

    def show(self, snapshot: Snapshot) -> None:
        """Let pages that are opened from now on begin with this; costs nothing until then."""
        self._snapshot = snapshot

    def dress(self, page: bytes) -> bytes:
        """Put the pictures into viser's page, before its script; may be called on any thread.

        Args:
            page: HTML whose only script stands in its head.

        Returns:
            The same page where there is nothing to show yet.
        """
        snapshot = self._snapshot
        head, script, rest = page.partition(_SCRIPT)
        if snapshot is None or snapshot.scene is None or not script:
            return page
        look = self._html(snapshot).encode()
        # The body begins here; browsers pass over the tags that would begin it later.
        return b"".join((head, b"</head><body>", look, script, rest))

    def _html(self, snapshot: Snapshot) -> str:
        assert snapshot.scene is not None
        field = drape(snapshot, Preferences(), self._workspace)
        rgba = field.rgba if field is not None else None
        table = data_uri(flat_table(snapshot.scene.poses, rgba, self._workspace))
        agent = snapshot.policy.label if snapshot.policy is not None else ""
        maps = [_figure(draped, agent) for draped in self._maps(snapshot)]
        return self._template.substitute(
            table=table,
            caption=_caption(field) if field is not None else "",
            maps="".join(maps),
            storage_key=STORAGE_KEY,
            light_table=_css(LIGHT.table),
            light_border=_css(LIGHT.border),
            dark_table=_css(DARK.table),
            dark_border=_css(DARK.border),
        )

    def _maps(self, snapshot: Snapshot) -> list[DrapedField]:
        chosen = [Preferences(field=key, opacity=1.0) for key in _MAPS]
        maps = [drape(snapshot, preferences, self._workspace) for preferences in chosen]
        return [draped for draped in maps if draped is not None]


def _figure(draped: DrapedField, agent: str) -> str:
    return f'<figure><img alt="" src="{data_uri(draped.rgba)}">{_caption(draped, agent)}</figure>'


def _caption(draped: DrapedField, agent: str = "") -> str:
    label = draped.label.replace("of the agent", f"of {agent}") if agent else draped.label
    return f"<figcaption>{escape(label)}{draped.legend}</figcaption>"


def _css(colour: Colour) -> str:
    return "rgb({}, {}, {})".format(*colour)
