"""The table in Bullet: scenes, pushes, the camera and the scenarios."""

from singulate.simulation.physics import Physics
from singulate.simulation.scenarios import SCENARIO_FAMILIES, Scenario, make_scenario
from singulate.simulation.scene import PushFrame, PushOutcome, Scene

__all__ = [
    "SCENARIO_FAMILIES",
    "Physics",
    "PushFrame",
    "PushOutcome",
    "Scenario",
    "Scene",
    "make_scenario",
]
