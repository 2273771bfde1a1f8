"""What agents are compared with, by the names that stand where a checkpoint could."""

from collections.abc import Callable

from singulate.agents.baselines import BASELINES
from singulate.agents.policy import Policy
from singulate.rewardmap.exhaustive import ExhaustivePolicy

YARDSTICKS: dict[str, Callable[[], Policy]] = {**BASELINES, "exhaustive": ExhaustivePolicy}
"""Policies without learning, and exhaustive search, which sees the true poses."""
