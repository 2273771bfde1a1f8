"""Trains an agent in this process."""

import json
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import torch

from singulate.checkpoints.durable import replace_file
from singulate.runs import Heartbeat, RunDirectory, RunLock, RunStatus
from singulate.training.callback import SessionCallback
from singulate.training.config import TrainingConfig
from singulate.training.controls import Controls, stop_on_signals
from singulate.training.envs import make_training_envs
from singulate.training.links import Links, Progress
from singulate.training.model import build_training_model, encoder_of
from singulate.training.resuming import resume_training
from singulate.training.session import TrainingSession, TrainingStopped
from singulate.training.telemetry import Telemetry


@dataclass(frozen=True)
class TrainingResult:
    """How a training ended.

    Attributes:
        run_dir: Its run directory.
        state: ``finished`` or ``stopped``.
        was_interrupted: Whether Ctrl-C stopped it.
        checkpoint: Its last checkpoint.
        progress: How far it came.
    """

    run_dir: Path
    state: str
    was_interrupted: bool
    checkpoint: Path
    progress: Progress


def train(
    config: TrainingConfig,
    run_dir: Path,
    resume: bool = False,
    on_progress: Callable[[Progress], None] | None = None,
    on_trouble: Callable[[str], None] | None = None,
) -> TrainingResult:
    """Train until the steps are done or somebody asks to stop.

    PPO and TRPO stop at the end of a rollout, so they may go up to `n_steps` - 1 pushes beyond the
    total; all others up to `num_envs` - 1.

    Args:
        config: The run's settings.
        run_dir: Directory of the run: new, or one to continue.
        resume: Continue from the newest checkpoint: the agent learns exactly as if the run had
            never stopped. Running means of the metrics begin anew.
        on_progress: Called after every push.
        on_trouble: Called when the training waits because something cannot be written, a full
            disk say, with the reason. It goes on once somebody resumes the run; what this raises
            ends the training instead.

    Raises:
        RunError: If the directory holds a run already (or none, on `resume`), is being written by
            another process, or is not writable; also if the last rows could not be recorded, after
            the last checkpoint was saved.
        WorkerError: If an environment in a worker failed, or workers cannot be kept alive.
        ResumeError: If none of the run's checkpoints is intact, or it does not fit; the record
            and the settings are then as before.
        CheckpointError: If a checkpoint cannot be written, or the encoder of a new run cannot be
            read.
    """
    run = RunDirectory(run_dir)
    if resume:
        run.open()
    has_checkpoint = resume and run.latest_checkpoint() is not None
    encoder = None if has_checkpoint else encoder_of(config)
    if not resume:
        run.create(config.to_dict())
    torch.set_num_threads(config.num_threads)
    # Adam's moments of idle weights decay into denormal numbers, which made updates 4 times slower.
    torch.set_flush_denormal(True)
    with ExitStack() as stack:
        stack.enter_context(RunLock(run_dir))
        status = RunStatus(state="starting", total_steps=config.total_timesteps)
        heartbeat = stack.enter_context(Heartbeat(run_dir, status))
        controls = stack.enter_context(Controls(run_dir, heartbeat))
        stack.enter_context(stop_on_signals(controls))
        envs = make_training_envs(config)
        stack.callback(envs.close)
        model = build_training_model(config, envs, encoder)
        resumed_step = resume_training(model, envs, run) if resume else None
        if resume:
            text = json.dumps(config.to_dict(), indent=2) + "\n"
            replace_file(run.config_path, text.encode())
        telemetry = stack.enter_context(Telemetry(run_dir, resumed_step))
        links = Links(telemetry, heartbeat, controls, on_progress, on_trouble)
        session = TrainingSession(config, run_dir, model, envs, links)
        if resumed_step:
            session.mark_checkpoint()
        return _learn(session)


def _learn(session: TrainingSession) -> TrainingResult:
    model, heartbeat = session.model, session.heartbeat
    if heartbeat.status.state == "starting":
        heartbeat.update(state="running", num_steps=model.num_timesteps)
    session.record_event("started", step=model.num_timesteps)
    state = "finished"
    try:
        model.learn(
            max(session.config.total_timesteps - model.num_timesteps, 0),
            callback=SessionCallback(session),
            log_interval=None,  # type: ignore[arg-type]
            reset_num_timesteps=False,
        )
    except TrainingStopped:
        state = "stopped"
    checkpoint = session.save_checkpoint()
    session.record_event(state, step=model.num_timesteps)
    error = session.last_commit()
    heartbeat.update(state=state, num_steps=model.num_timesteps, eta_s=None, error=error)
    interrupted = session.controls.was_interrupted
    return TrainingResult(session.run.path, state, interrupted, checkpoint, session.progress)
