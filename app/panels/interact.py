"""Tab *Interact*: put up a scene, aim, push, let the agent push, watch."""

from app.choices import MAX_SEED, MAX_SPEED, MIN_SPEED, SCENARIOS
from app.commands import (
    AgentPush,
    LoadPolicy,
    ResetScene,
    SetScenePaused,
    SetSpeed,
    SetWatching,
    StepScene,
    Undo,
)
from app.panels.blocks import BlocksPanel
from app.panels.checks import number, one_of, whole_number
from app.panels.context import PanelContext
from app.panels.icons import AGENT_PUSH
from app.panels.listening import listen, on_pick, on_press, show_value
from app.panels.marked_choice import MarkedChoice, add_switch
from app.panels.markup import block, dimmed, escape, show
from app.panels.naming import name_for
from app.panels.push_report import PushReportView
from app.panels.watch import Watch
from app.snapshot import SceneSnapshot, Snapshot
from singulate.geometry import Direction

CHOSEN = ("▲ up", "▶ right", "▼ down", "◀ left")
OTHERS = ("△ up", "▷ right", "▽ down", "◁ left")
NO_POLICY = "none loaded"


class InteractPanel:
    """The scene's controls and the report on the last push."""

    def __init__(self, context: PanelContext) -> None:
        self._context = context
        self._scene: SceneSnapshot | None = None
        self._sources: dict[str, str] = {}
        self._scene_watch, self._policy_watch = Watch(), Watch()
        self.state = context.gui.add_html(_scene_html(None))
        self._add_scene_controls()
        self._add_agent_controls()
        self._add_motion_controls()
        self._report = PushReportView(context.gui, context.name)

    def _add_scene_controls(self) -> None:
        gui, context = self._context.gui, self._context
        self.scenario = gui.add_dropdown("Scenario", SCENARIOS, initial_value="random-2")
        self.seed = gui.add_number("Seed", 0, min=0, max=MAX_SEED, step=1)
        self._scene_buttons = gui.add_button_group("Table", ("Reset", "Next seed", "Undo"))
        self.blocks = BlocksPanel(context)
        self.directions = MarkedChoice(
            gui, "Push towards", OTHERS, CHOSEN, self._choose_direction, hint="Keys 1 to 4"
        )
        listen(self.scenario, one_of("scenario", SCENARIOS),
               lambda _: self.reset(), context.report)  # fmt: skip
        listen(self.seed, whole_number("seed", 0, MAX_SEED),
               lambda _: self.reset(), context.report)  # fmt: skip
        on_pick(self._scene_buttons, self._press_scene_button)

    def _add_agent_controls(self) -> None:
        gui, context = self._context.gui, self._context
        self.policy = gui.add_dropdown("Agent", (NO_POLICY,))
        self.agent_push = gui.add_button("Agent pushes", icon=AGENT_PUSH)
        self.watching = add_switch(
            gui, "Watch it play", lambda is_on: context.submit(SetWatching(is_on))
        )
        listen(self.policy, lambda value: one_of("agent", self.policy.options)(value),
               self._load_policy, context.report)  # fmt: skip
        on_press(self.agent_push, lambda: context.submit(AgentPush()))

    def _add_motion_controls(self) -> None:
        gui, context = self._context.gui, self._context
        self.speed = gui.add_slider("Speed", MIN_SPEED, MAX_SPEED, 0.1, 1.0)
        self.motion = gui.add_button_group("Motion", ("Pause", "One step"))
        listen(self.speed, number("speed", MIN_SPEED, MAX_SPEED),
               lambda value: context.submit(SetSpeed(value)), context.report)  # fmt: skip
        on_pick(self.motion, lambda index: self.step() if index else self.pause_or_go())

    def reset(self) -> None:
        """Put up the scene that the form names.

        Raises:
            InvalidValueError: If the form holds a value that is not allowed.
        """
        scenario = one_of("scenario", SCENARIOS)(self.scenario.value)
        seed = whole_number("seed", 0, MAX_SEED)(self.seed.value)
        self._context.submit(ResetScene(scenario, seed))

    def pause_or_go(self) -> None:
        """Freeze the scene's motion, or release it."""
        is_paused = self._scene is not None and self._scene.is_paused
        self._context.submit(SetScenePaused(not is_paused))

    def step(self) -> None:
        """One simulation step; freezes the scene first where it is moving."""
        if self._scene is not None and not self._scene.is_paused:
            self._context.submit(SetScenePaused(True))
        self._context.submit(StepScene())

    def _press_scene_button(self, index: int) -> None:
        if index == 1 and self._scene is not None:
            seed = (self._scene.seed + 1) % (MAX_SEED + 1)
            self._context.submit(ResetScene(self._scene.scenario, seed))
        elif index == 2:
            self._context.submit(Undo())
        else:
            self.reset()

    def _choose_direction(self, index: int) -> None:
        self._context.preferences.direction = Direction(index)

    def _load_policy(self, label: str) -> None:
        source = self._sources.get(label)
        if source is not None:
            self._context.submit(LoadPolicy(source))

    def update(self, snapshot: Snapshot) -> None:
        """Show a snapshot."""
        self._scene = scene = snapshot.scene
        self.blocks.update(scene)
        self.directions.show(self._context.preferences.direction)
        self._update_policies(snapshot)
        show(self.state, _scene_html(scene, self._context.name))
        if scene is not None and self._scene_watch.has_changed(
            scene.scenario, scene.seed, scene.speed, scene.is_paused, scene.is_watching
        ):
            if scene.scenario in SCENARIOS:
                show_value(self.scenario, scene.scenario)
            show_value(self.seed, scene.seed)
            show_value(self.speed, min(max(scene.speed, MIN_SPEED), MAX_SPEED))
            self.watching.show(0 if scene.is_watching else 1)
            self.motion.options = ("Go on" if scene.is_paused else "Pause", "One step")
        self._report.update(None if scene is None else scene.last_push)

    def _update_policies(self, snapshot: Snapshot) -> None:
        policy = snapshot.policy
        current = NO_POLICY if policy is None else policy.label
        if not self._policy_watch.has_changed(snapshot.policies, current):
            return
        self._sources = dict(snapshot.policies)
        listed = tuple(self._sources)
        options = listed if current in listed else (current, *listed)
        self.policy.options = options
        show_value(self.policy, current)
        self.agent_push.disabled = policy is None


def _scene_html(scene: SceneSnapshot | None, own_name: str = "") -> str:
    if scene is None:
        return block(dimmed("The table is being set up…"))
    seen = f"camera sees {scene.num_segments} of {scene.num_blocks} blocks"
    state = "singulated" if scene.is_success else seen
    if scene.is_pushing:
        state = f"{name_for(own_name, scene.pushed_by)} pushing…"
    elif scene.held_block is not None:
        state = f"{name_for(own_name, scene.held_by)} moving a block…"
    paused = " · paused" if scene.is_paused else ""
    changed = " · rearranged" if scene.is_rearranged else ""
    recipe = f"<b>{escape(scene.scenario)}</b> · seed {scene.seed}{changed}"
    return block(recipe, dimmed(state + paused))
