"""Words and colours for the state of a training run."""

from app.snapshot import RunSnapshot

STATE_COLOURS = {
    "running": "#2f9e44",
    "starting": "#1c7ed6",
    "pausing": "#e8890c",
    "paused": "#e8890c",
    "stopping": "#e8890c",
    "stopped": "#868e96",
    "finished": "#1c7ed6",
    "failed": "#e03131",
    "died": "#e03131",
}


def duration(seconds: float) -> str:
    """A time span for people.

    Example:
        >>> [duration(value) for value in (0.4, 42.0, 95.0, 3700.0, 200000.0)]
        ['0 s', '42 s', '1 min 35 s', '1 h 1 min', '2 d 7 h']
    """
    whole = max(0, int(seconds))
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    if whole < 86400:
        return f"{whole // 3600} h {whole % 3600 // 60} min"
    return f"{whole // 86400} d {whole % 86400 // 3600} h"


def progress_text(run: RunSnapshot) -> str:
    """Pushes done and speed."""
    text = f"{run.num_steps:,} / {run.total_steps:,} pushes"
    return f"{text} · {run.pushes_per_second:.0f}/s" if run.state == "running" else text


def age_text(run: RunSnapshot) -> str:
    """Time left, and how long ago the trainer gave a sign of life."""
    is_fresh = run.state == "running" and run.age_s < 3.0
    age = "updated just now" if is_fresh else f"updated {duration(run.age_s)} ago"
    if run.state == "running" and run.eta_s is not None:
        return f"{duration(run.eta_s)} left · {age}"
    return age
