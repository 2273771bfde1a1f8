"""Recipes for the start of a scene."""

from singulate.simulation.scenarios.registry import SCENARIO_FAMILIES, make_scenario
from singulate.simulation.scenarios.scenario import Scenario

__all__ = ["SCENARIO_FAMILIES", "Scenario", "make_scenario"]
