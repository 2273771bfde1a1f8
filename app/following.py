"""Which policy is loaded: a chosen one, or the newest of the run that is watched."""

from app.links.policy_link import PolicyLink
from app.training_link import TrainingLink
from singulate.exceptions import InvalidValueError


class Following:
    """Keeps the policy of the watched run up to date, where somebody wants to see it.

    Whoever starts a training wants to see what it learns: its policy is loaded as soon as there is
    a checkpoint, unless another one is chosen in the meantime.

    Args:
        policy: Where policies are loaded.
        training: The watched run.
    """

    def __init__(self, policy: PolicyLink, training: TrainingLink) -> None:
        self._policy = policy
        self._training = training
        self._done_with = ""
        """The last run started here that has been loaded, or been passed over for another one."""

    def choose(self, source: str) -> None:
        """Load a checkpoint directory, or with ``run`` what the watched run has learned.

        Raises:
            InvalidValueError: If there is no such run, or it has no checkpoint yet.
        """
        self._done_with = self._training.started_run
        if source != "run":
            self._policy.load(source)
            return
        run = self._training.snapshot
        if run is None or not run.last_checkpoint:
            raise InvalidValueError(
                "policy", "run", "a watched run with a checkpoint: save one, or wait for one"
            )
        self._policy.load(run.last_checkpoint, is_live=True)

    def update(self) -> None:
        """Load a new checkpoint, if it is wanted."""
        run = self._training.snapshot
        if run is None or not run.last_checkpoint:
            return
        started_run = self._training.started_run
        is_new = run.run_dir == started_run != self._done_with
        if self._policy.is_following or is_new:
            self._done_with = started_run
            self._policy.load(run.last_checkpoint, is_live=True)
