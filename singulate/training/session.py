"""One training under way: what happens after each push and at each safe point."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

from stable_baselines3.common.base_class import BaseAlgorithm

from singulate.agents.loading import tensors_of
from singulate.checkpoints import Manifest, prune, save_checkpoint
from singulate.exceptions import CheckpointError, RunError
from singulate.runs import RunDirectory
from singulate.runs.record import METRICS_EVERY
from singulate.training.config import TrainingConfig
from singulate.training.envs import TrainingEnvs
from singulate.training.links import Links, Progress
from singulate.training.metrics import EpisodeMetrics, model_metrics
from singulate.training.speed import SpeedMeter
from singulate.training.training_state import capture_training


class TrainingStopped(Exception):  # noqa: N818 - no error: leaves stable-baselines3's loop
    """Raised between two rollouts, after a checkpoint, because somebody asked to stop."""


class TrainingSession:
    """Acts for a training on its run directory and on what people ask of it.

    Args:
        config: The run's settings.
        run_dir: The run's directory, locked by this process.
        model: The model in training.
        envs: Its environments.
        links: Where its results go and its orders come from.
    """

    def __init__(
        self,
        config: TrainingConfig,
        run_dir: Path,
        model: BaseAlgorithm,
        envs: TrainingEnvs,
        links: Links,
    ) -> None:
        self.config = config
        self.run = RunDirectory(run_dir)
        self.model = model
        self.envs = envs
        self.telemetry = links.telemetry
        self.heartbeat = links.heartbeat
        self.controls = links.controls
        self.metrics = EpisodeMetrics(config.num_envs)
        self._on_progress = links.on_progress
        self._on_trouble = links.on_trouble
        self._speed = SpeedMeter()
        self._checkpoint_step = -1

    @property
    def progress(self) -> Progress:
        """How far it is."""
        num_steps, total = self.model.num_timesteps, self.config.total_timesteps
        return Progress(
            num_steps,
            total,
            self._speed.pushes_per_second,
            self._speed.eta_s(total - num_steps),
            self.metrics.num_episodes,
            self.metrics.success_rate,
            self.metrics.mean_reward,
        )

    def after_push(
        self, env_index: int, info: Mapping[str, Any], predicted: float | None, is_done: bool
    ) -> None:
        """Record a push and, now and then, metrics.

        Args:
            env_index: Environment that pushed; all push together, and are told of in turns.
            info: What the environment said about it.
            predicted: Reward that the agent expected.
            is_done: Whether it ended its episode.
        """
        step = self.model.num_timesteps - self.config.num_envs + 1 + env_index
        with self._recording():
            self.telemetry.add_push(step, info, predicted)
        self.metrics.add_push(
            info["reward"], info["reward_terms"], info["is_success"], is_done, env_index
        )
        self._speed.add(step)
        progress = self.progress
        self.heartbeat.update(
            num_steps=step, pushes_per_second=progress.pushes_per_second, eta_s=progress.eta_s
        )
        if step % METRICS_EVERY == 0:
            values = {**self.metrics.collect(), **model_metrics(self.model)}
            values["time/pushes_per_second"] = progress.pushes_per_second
            with self._recording():
                self.telemetry.add_metrics(step, values)
        if self._on_progress is not None:
            self._on_progress(progress)

    def note_losses(self) -> None:
        """Record workers that were lost and replaced, and show the last one."""
        for loss in self.envs.take_losses():
            self.record_event("worker_replaced", step=self.model.num_timesteps, **asdict(loss))
            self.heartbeat.update(notice=f"{loss.reason}, it was replaced")

    def between_pushes(self) -> None:
        """Wait while paused, in the middle of a rollout, where no checkpoint can be saved."""
        while self.controls.is_pausing:
            self._tell_trouble()
            self.controls.wait_for_resume()
            self._go_on()

    def at_safe_point(self) -> None:
        """Between two rollouts: save a checkpoint where one is due, wait, or stop.

        Raises:
            TrainingStopped: If somebody asked for it.
        """
        while True:
            wanted = self.controls.take_checkpoint_request() or self.controls.is_stopping
            if wanted or self._is_checkpoint_due():
                self._save_or_pause()
            if self.controls.is_stopping:
                raise TrainingStopped
            if not self.controls.is_pausing:
                return
            self._tell_trouble()
            self.controls.wait_while_paused()
            self._go_on()

    def save_checkpoint(self) -> Path:
        """Save all that is needed to continue from here.

        Raises:
            CheckpointError: If it cannot be written or the training has diverged.
        """
        step = self.model.num_timesteps
        directory = self.run.checkpoint_path(step)
        if step == self._checkpoint_step and directory.exists():
            return directory
        with self._recording():  # no checkpoint may know of pushes that the record can still lose
            self.telemetry.record.flush()
        manifest = Manifest(
            agent=self.config.agent,
            agent_config=self.config.agent_config,
            env_config=self.config.env.to_dict(),
            step=step,
            notes={"seed": self.config.seed},
        )
        network = self.config.kind.network_of(self.model)
        files = capture_training(self.model, self.envs)
        save_checkpoint(directory, tensors_of(network), manifest, files)
        prune(self.run.checkpoints_path, self.config.num_checkpoints)
        self._checkpoint_step = step
        self.record_event("checkpoint", step=step)
        return directory

    def record_event(self, kind: str, **detail: Any) -> None:
        """Record something that happened."""
        with self._recording():
            self.telemetry.record.add_event(kind, **detail)

    def last_commit(self) -> str:
        """Commit what is waiting; why it failed, empty if it did not."""
        try:
            self.telemetry.record.flush()
        except RunError as error:
            return str(error)
        return ""

    def mark_checkpoint(self) -> None:
        """Note that the present state was just loaded from a checkpoint."""
        self._checkpoint_step = self.model.num_timesteps

    def _is_checkpoint_due(self) -> bool:
        every = self.config.checkpoint_every
        step, last = self.model.num_timesteps, self._checkpoint_step
        return last < 0 or step // every > last // every

    def _save_or_pause(self) -> None:
        error = self.last_commit()
        try:
            if not error or self.controls.is_stopping:
                self.save_checkpoint()
        except CheckpointError as failure:
            if self.controls.is_stopping:
                raise
            error = str(failure)
            self.record_event("checkpoint_failed", reason=error)
        if error:
            self.controls.request("pause")
        if error != self.heartbeat.status.error:
            self.heartbeat.update(error=error)

    def _tell_trouble(self) -> None:
        if self._on_trouble is not None and self.heartbeat.status.error:
            self._on_trouble(self.heartbeat.status.error)

    def _go_on(self) -> None:
        """After a pause: write what could not be written, or pause again."""
        self._speed.restart()
        if not self.controls.is_pausing:
            self.heartbeat.update(error="")
            with self._recording():
                self.telemetry.record.flush()

    @contextmanager
    def _recording(self) -> Iterator[None]:
        """A record that cannot be written pauses the training; it keeps its rows meanwhile."""
        try:
            yield
        except RunError as error:
            self.heartbeat.update(error=str(error))
            self.controls.request("pause")
