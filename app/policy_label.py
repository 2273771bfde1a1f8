"""What people call a policy, the same in the list and once it is loaded."""

from pathlib import Path


def policy_label(checkpoint: Path, step: int) -> str:
    """Name and training steps of a checkpoint directory.

    Example:
        >>> policy_label(Path("checkpoints/dqn-random-2"), 20000)
        'dqn-random-2 · 20,000 steps'
        >>> policy_label(Path("runs/night/checkpoints/step-000001000"), 1000)
        'night · 1,000 steps'
    """
    path = checkpoint.absolute()
    is_of_run = path.parent.name == "checkpoints" and path.name.startswith("step-")
    return f"{path.parent.parent.name if is_of_run else path.name} · {step:,} steps"
