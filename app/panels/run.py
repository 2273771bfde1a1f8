"""Left panel: the watched training run and the form for a new one."""

from collections import Counter
from pathlib import PurePath

from app.choices import AGENTS, MAX_SEED, MAX_TIMESTEPS, SCENARIOS, USUAL_PUSHES
from app.commands import (
    PauseTraining,
    ResumeTraining,
    SaveCheckpoint,
    StartTraining,
    StopTraining,
    WatchRun,
)
from app.panels.checks import one_of, whole_number
from app.panels.context import PanelContext
from app.panels.icons import PAUSE_TRAINING, TRAIN
from app.panels.listening import listen, on_press, show_value
from app.panels.markup import block, dimmed, escape, show
from app.panels.status_text import STATE_COLOURS, age_text, progress_text
from app.panels.train_button import train_button
from app.panels.watch import Watch
from app.snapshot import RunSnapshot, Snapshot

NO_RUN = "none yet"


class RunPanel:
    """Status line, progress, the train button, and settings of a new run."""

    def __init__(self, context: PanelContext) -> None:
        self._context = context
        self._run: RunSnapshot | None = None
        self._run_dirs: dict[str, str] = {}
        self._watch, self._runs_watch = Watch(), Watch()
        gui = context.gui
        self.status = gui.add_html(_status_html(None))
        self.progress = gui.add_progress_bar(0.0, visible=False)
        self.train = gui.add_button("Start training", icon=TRAIN)
        self.save = context.secondary.add("Save checkpoint", disabled=True)
        self.stop = context.secondary.add("Stop after this rollout", disabled=True)
        on_press(self.train, self.train_or_pause, context.report)
        on_press(self.save, lambda: context.submit(SaveCheckpoint()))
        on_press(self.stop, lambda: context.submit(StopTraining()))
        self._add_form()

    def _add_form(self) -> None:
        gui, context = self._context.gui, self._context
        with gui.add_folder("New run"):
            self.agent = gui.add_dropdown("Agent", AGENTS, initial_value=AGENTS[0])
            self.scenario = gui.add_dropdown("Scenario", SCENARIOS, initial_value="random-2")
            usual = USUAL_PUSHES[AGENTS[0]]
            self.steps = gui.add_number("Pushes", usual, min=1, max=MAX_TIMESTEPS, step=1000)
            self.seed = gui.add_number("Seed", 0, min=0, max=MAX_SEED, step=1)
            self.new = context.secondary.add("Start new run")
        on_press(self.new, self._start, context.report)
        listen(self.agent, one_of("agent", AGENTS), self._suggest_pushes, context.report)
        self.runs = gui.add_dropdown("Watch run", (NO_RUN,), visible=False)
        listen(
            self.runs,
            lambda value: one_of("run", self.runs.options)(value),
            self._watch_run,
            context.report,
        )

    def _suggest_pushes(self, agent: str) -> None:
        show_value(self.steps, USUAL_PUSHES[agent])

    def _watch_run(self, name: str) -> None:
        run_dir = self._run_dirs.get(name)
        if run_dir is not None:
            self._context.submit(WatchRun(run_dir))

    def train_or_pause(self) -> None:
        """What the train button does in the present state; also behind key T.

        Raises:
            InvalidValueError: If the form for a new run holds a value that is not allowed.
        """
        action = train_button(self._run).action
        if action == "start":
            self._start()
        elif action == "pause":
            self._context.submit(PauseTraining())
        elif action == "resume":
            self._context.submit(ResumeTraining())

    def _start(self) -> None:
        self._context.submit(
            StartTraining(
                agent=one_of("agent", AGENTS)(self.agent.value),
                scenario=one_of("scenario", SCENARIOS)(self.scenario.value),
                total_timesteps=whole_number("pushes", 1, MAX_TIMESTEPS)(self.steps.value),
                seed=whole_number("seed", 0, MAX_SEED)(self.seed.value),
            )
        )

    def update(self, snapshot: Snapshot) -> None:
        """Show a snapshot."""
        self._run = run = snapshot.run
        if self._runs_watch.has_changed(snapshot.runs, run.run_dir if run else ""):
            self._update_runs(snapshot.runs, run)
        show(self.status, _status_html(run))
        if not self._watch.has_changed(run and (run.state, run.num_steps, run.total_steps)):
            return
        state = run.state if run else ""
        button = train_button(run)
        self.train.label = button.label
        self.train.disabled = button.action is None
        self.train.icon = PAUSE_TRAINING if button.action == "pause" else TRAIN
        self.save.disabled = state not in {"running", "paused"}
        self.stop.disabled = state not in {"running", "paused"}
        self.new.disabled = state in {"starting", "running", "pausing", "paused", "stopping"}
        self.progress.visible = run is not None
        if run is not None and run.total_steps > 0:
            show_value(self.progress, min(100.0, 100.0 * run.num_steps / run.total_steps))
            self.progress.animated = state == "running"

    def _update_runs(self, runs: tuple[str, ...], run: RunSnapshot | None) -> None:
        current = run.run_dir if run else ""
        listed = runs if run is None or current in runs else (current, *runs)
        self._run_dirs = name_runs(listed)
        options = tuple(self._run_dirs) if run else (NO_RUN, *self._run_dirs)
        names = {run_dir: name for name, run_dir in self._run_dirs.items()}
        self.runs.options = options
        show_value(self.runs, names.get(current, NO_RUN))
        self.runs.visible = len(options) > 1


def name_runs(run_dirs: tuple[str, ...]) -> dict[str, str]:
    """Short names of run directories; those that would share one keep their whole path.

    Example:
        >>> name_runs(("/runs/a", "/runs/b", "/old/b"))
        {'a': '/runs/a', '/runs/b': '/runs/b', '/old/b': '/old/b'}
    """
    counts = Counter(PurePath(run_dir).name for run_dir in run_dirs)
    return {
        PurePath(run_dir).name if counts[PurePath(run_dir).name] == 1 else run_dir: run_dir
        for run_dir in run_dirs
    }


def _status_html(run: RunSnapshot | None) -> str:
    if run is None:
        return block(dimmed("No training yet. Start one below; the table works without it."))
    colour = STATE_COLOURS.get(run.state, "#868e96")
    dot = (
        f'<span style="display:inline-block;width:8px;height:8px;border-radius:4px;'
        f'background:{colour};margin-right:6px"></span>'
    )
    headline = f"<div>{dot}<b>{escape(run.state)}</b> · {escape(run.agent)} · " + (
        f"{escape(run.scenario)}</div>"
    )
    reason = (
        f'<div style="color:{STATE_COLOURS["failed"]};font-size:12px">{escape(run.reason)}</div>'
        if run.reason
        else ""
    )
    return block(headline, dimmed(progress_text(run)), dimmed(age_text(run)), reason)
