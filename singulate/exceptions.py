"""Errors whose text is one line that a user can act on."""


class SingulateError(Exception):
    """Base of every error that this package raises on purpose.

    The command line prints ``str(error)`` and exits with status 2.
    """


class InvalidValueError(SingulateError, ValueError):
    """A value from outside that is not allowed.

    Args:
        key: What was set, as the user knows it (``scenario``, ``blocks[1].x``).
        value: The value that was given.
        allowed: What would have been accepted.
    """

    def __init__(self, key: str, value: object, allowed: str) -> None:
        super().__init__(f"{key}: {_shorten(value)} is not allowed; allowed: {allowed}")
        self.key = key
        self.value = value
        self.allowed = allowed

    def __reduce__(self) -> tuple[type["InvalidValueError"], tuple[str, object, str]]:
        return type(self), (self.key, self.value, self.allowed)


class SimulationError(SingulateError, RuntimeError):
    """The physics produced a state that is not finite; the world has been rebuilt."""


class CheckpointError(SingulateError):
    """A checkpoint is missing, truncated, tampered with or not one of ours."""


class ResumeError(CheckpointError):
    """Nothing of a run directory can be continued; it is left as it is."""


class RunError(SingulateError):
    """A run directory is missing, damaged, not writable or in use by another process."""


def _shorten(value: object, limit: int = 120) -> str:
    text = repr(value).replace("\n", " ")
    return text if len(text) <= limit else text[: limit - 3] + "..."
