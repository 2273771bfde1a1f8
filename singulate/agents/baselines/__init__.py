"""Policies without learning, by the names that stand where a checkpoint could.

To add one: a file in this folder and one entry in `BASELINES`. One that has to see more than an
observation is added in `singulate.evaluation.yardsticks`.
"""

from collections.abc import Callable

from singulate.agents.baselines.geometric import GeometricPolicy
from singulate.agents.baselines.random_contact import RandomContactPolicy
from singulate.agents.policy import Policy
from singulate.agents.random_policy import RandomPolicy

BASELINES: dict[str, Callable[[], Policy]] = {
    "random": RandomPolicy,
    "random-contact": RandomContactPolicy,
    "geometric": GeometricPolicy,
}

__all__ = ["BASELINES"]
