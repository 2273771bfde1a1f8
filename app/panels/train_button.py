"""The one button that starts, pauses and resumes training; key T does the same."""

from dataclasses import dataclass

from app.snapshot import RunSnapshot


@dataclass(frozen=True)
class TrainButton:
    """How the button looks and what it does.

    Attributes:
        label: Text on it.
        action: ``start``, ``pause``, ``resume``, or None while a change is under way.
    """

    label: str
    action: str | None


def train_button(run: RunSnapshot | None) -> TrainButton:
    """The button's state for the watched run."""
    if run is None or run.state == "finished":
        return TrainButton("Start training", "start")
    match run.state:
        case "running":
            return TrainButton("Pause", "pause")
        case "starting" | "pausing" | "stopping":
            return TrainButton(f"{run.state}…", None)
        case _:
            return TrainButton("Resume", "resume")
