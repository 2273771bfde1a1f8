"""The table in Bullet: scenes, pushes, the camera and the scenarios.

Bullet is loaded by the first use of `Scene`: whoever needs scenarios alone does without it.
"""

from typing import TYPE_CHECKING, Any

from singulate.simulation.outcome import PushFrame, PushOutcome
from singulate.simulation.physics import Physics
from singulate.simulation.scenarios import SCENARIO_FAMILIES, Scenario, make_scenario

if TYPE_CHECKING:
    from singulate.simulation.scene import Scene

__all__ = [
    "SCENARIO_FAMILIES",
    "Physics",
    "PushFrame",
    "PushOutcome",
    "Scenario",
    "Scene",
    "make_scenario",
]


def __getattr__(name: str) -> Any:
    if name == "Scene":
        from singulate.simulation.scene import Scene

        return Scene
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
