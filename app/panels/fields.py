"""Tab *Fields*: which field lies on the table, all directions side by side, inspection."""

from collections.abc import Callable
from typing import Any

import numpy as np
import viser

from app.fields.catalogue import FIELD_KINDS, FIELDS_BY_KEY, FIELDS_BY_LABEL, FieldKind
from app.fields.drape import span_of
from app.fields.field_image import Span, field_image, picture_image, value_span
from app.panels.checks import number, one_of
from app.panels.context import PanelContext
from app.panels.field_age import policy_line, reward_map_line
from app.panels.inspection import inspection_html
from app.panels.listening import listen, show_value
from app.panels.marked_choice import add_switch
from app.panels.markup import block, dimmed, picture, ring, show, title
from app.panels.montage import montage_html
from app.panels.watch import Throttle, Watch
from app.preferences import CHOICES, SPANS, Preferences
from app.snapshot import Snapshot

PICTURE_INTERVAL = 0.25
"""Shortest time between two versions of the small pictures [s]."""


class FieldsPanel:
    """Choice of the draped field, small multiples and inspection."""

    def __init__(self, context: PanelContext) -> None:
        self._context = context
        self._watches = {name: Watch() for name in ("form", "inputs", "reward", "q", "inspect")}
        self._throttle = Throttle(PICTURE_INTERVAL)
        gui, preferences = context.gui, context.preferences
        self.field = gui.add_dropdown(
            "On the table", tuple(FIELDS_BY_LABEL), hint="Keys F and G",
            initial_value=FIELDS_BY_KEY[preferences.field].label,
        )  # fmt: skip
        self.choice = gui.add_dropdown("Direction", CHOICES, initial_value=preferences.choice)
        self._opacity = gui.add_slider("Opacity", 0.0, 1.0, 0.05, preferences.opacity)
        self._span = gui.add_dropdown("Colours span", SPANS, initial_value=preferences.span)
        self._inspects = add_switch(
            gui, "A click", _keep(preferences, "click_inspects"), ("inspects", "pushes")
        )
        self.inspection = gui.add_html("", visible=False)
        self._all = add_switch(
            gui, "All directions", _keep(preferences, "shows_all_directions"), ("show", "hide")
        )
        self.reward = gui.add_html("")
        self.q = gui.add_html("")
        self.inputs = gui.add_html("")
        self._listen()

    def _listen(self) -> None:
        report, preferences = self._context.report, self._context.preferences
        listen(
            self.field,
            one_of("field", FIELDS_BY_LABEL),
            lambda label: setattr(preferences, "field", FIELDS_BY_LABEL[label].key),
            report,
        )
        listen(self.choice, one_of("direction", CHOICES), _keep(preferences, "choice"), report)
        listen(self._opacity, number("opacity", 0.0, 1.0), _keep(preferences, "opacity"), report)
        listen(self._span, one_of("colours span", SPANS), _keep(preferences, "span"), report)

    def turn_page(self, by: int) -> None:
        """Lay the next (1) or previous (-1) field over the table."""
        keys = [kind.key for kind in FIELD_KINDS]
        index = (keys.index(self._context.preferences.field) + by) % len(keys)
        self._context.preferences.field = keys[index]

    def update(self, snapshot: Snapshot, now: float) -> None:
        """Show a snapshot."""
        self._update_form()
        if not self._throttle.is_due(now):
            return
        self._update_inspection(snapshot)
        self._update_montages(snapshot)
        self._update_inputs(snapshot)

    def _update_form(self) -> None:
        preferences = self._context.preferences
        kind = FIELDS_BY_KEY[preferences.field]
        pairs: tuple[tuple[viser.GuiInputHandle[Any], object], ...] = (
            (self.field, kind.label),
            (self.choice, preferences.choice),
            (self._span, preferences.span),
            (self._opacity, preferences.opacity),
        )
        self._all.show(0 if preferences.shows_all_directions else 1)
        self._inspects.show(0 if preferences.click_inspects else 1)
        if self._watches["form"].has_changed(*(value for _, value in pairs)):
            for handle, value in pairs:
                show_value(handle, value)
            self.choice.visible = kind.is_directional

    def _update_inspection(self, snapshot: Snapshot) -> None:
        truth, policy, scene = snapshot.reward_map, snapshot.policy, snapshot.scene
        place = self._context.preferences.inspected
        self.inspection.visible = self._context.preferences.click_inspects
        if self.inspection.visible and self._watches["inspect"].has_changed(
            place, truth and truth.values, policy and policy.q_map, scene and scene.distance_map
        ):
            show(self.inspection, inspection_html(snapshot, place, self._context.workspace))

    def _update_montages(self, snapshot: Snapshot) -> None:
        preferences = self._context.preferences
        is_shown = preferences.shows_all_directions
        truth, policy = snapshot.reward_map, snapshot.policy
        maps = (truth and truth.values, policy and policy.q_map)
        for key, handle, line in (
            ("reward", self.reward, reward_map_line(snapshot)),
            ("q", self.q, policy_line(snapshot)),
        ):
            own = maps[0] if key == "reward" else maps[1]
            other = maps if preferences.span == "reward and Q" else None
            if self._watches[key].has_changed(
                is_shown, own, preferences.span, line, *(other or ())
            ):
                handle.visible = is_shown
                if is_shown:
                    show(handle, self._montage(FIELDS_BY_KEY[key], snapshot, line))

    def _montage(self, kind: FieldKind, snapshot: Snapshot, line: str) -> str:
        preferences, workspace = self._context.preferences, self._context.workspace
        values = kind.read(snapshot, preferences, workspace)
        if values is None:
            return block(title(kind.label), dimmed(_missing_text(kind, snapshot, line)))
        stack = values.astype(np.float32, copy=False)
        spans = tuple(span_of(kind, each, stack, snapshot, preferences) for each in stack)
        shares = preferences.span != "each field"
        return block(title(kind.label, line), montage_html(kind, stack, spans, shares))

    def _update_inputs(self, snapshot: Snapshot) -> None:
        scene, policy = snapshot.scene, snapshot.policy
        density = None if policy is None else policy.start_density
        if scene is None or not self._watches["inputs"].has_changed(
            scene.distance_map, scene.rgb, density
        ):
            return
        distance = FIELDS_BY_KEY["distance_map"]
        span: Span = value_span(scene.distance_map)
        pictures = [
            ("Camera", picture_image(scene.rgb), ""),
            ("Distance", field_image(scene.distance_map, span, distance.colormap), ""),
            ("Mask", field_image(scene.mask.astype(np.float32), (0.0, 1.0), distance.colormap), ""),
        ]
        if policy is not None and density is not None:
            image = field_image(density, value_span(density), distance.colormap)
            modes = policy.start_modes
            marks = "".join(ring(mode, density.shape[0]) for mode in modes)
            name = f"Starts, {len(modes)} mode{'' if len(modes) == 1 else 's'}"
            pictures.append((name, image, marks))
        figures = "".join(
            f'<div style="flex:1;min-width:0">{picture(image, name, marks)}{dimmed(name)}</div>'
            for name, image, marks in pictures
        )
        html = f'<div style="display:flex;gap:4px">{figures}</div>'
        show(self.inputs, block(title("What the agent sees, and where it starts"), html))


def _keep(preferences: Preferences, name: str) -> Callable[[Any], None]:
    return lambda value: setattr(preferences, name, value)


def _missing_text(kind: FieldKind, snapshot: Snapshot, line: str) -> str:
    policy = snapshot.policy
    if kind.key == "q" and policy is not None and not policy.has_q_map:
        return f"{policy.kind} has no Q values; it says where it starts: see its start density."
    return line
