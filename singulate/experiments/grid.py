"""The cells of a sweep: every combination of agents, scenarios, settings and seeds."""

import itertools
from collections.abc import Mapping, Sequence
from typing import Any

from singulate.agents.registry import AGENTS, agent_kind
from singulate.envs import EnvConfig
from singulate.experiments.cell import Cell
from singulate.training.config import TrainingConfig


def combinations(axes: Mapping[str, Sequence[Any]]) -> list[dict[str, Any]]:
    """Every combination of one value an axis.

    Example:
        >>> combinations({"a": [1, 2], "b": [3]})
        [{'a': 1, 'b': 3}, {'a': 2, 'b': 3}]
    """
    return [dict(zip(axes, values, strict=True)) for values in itertools.product(*axes.values())]


def make_cells(
    agents: Sequence[str],
    scenarios: Sequence[str],
    settings: Sequence[Mapping[str, Any]],
    seeds: Sequence[int],
    *,
    steps: int,
    episodes: int = 1000,
    evaluation_seed: int = 7,
) -> list[Cell]:
    """The cells of a grid, equal ones once.

    Args:
        agents: Kinds of agents.
        scenarios: Scenarios; each agent is evaluated on the one that it was trained on.
        settings: Settings by name: ``learning_rate`` of every agent, ``dqn.learning_rate`` of one
            kind only, ``env.reward`` of the environment.
        seeds: Seeds of the trainings.
        steps: Pushes of each training.
        episodes: Episodes of each evaluation.
        evaluation_seed: Decides the scenes of the evaluations.

    Raises:
        InvalidValueError: If a name or a value is not allowed.
    """
    cells = []
    for agent, scenario, given, seed in itertools.product(agents, scenarios, settings, seeds):
        kind = agent_kind(agent)
        applied = {key: v for key, v in given.items() if not _is_of_another_agent(key, agent)}
        env_values = {"scenario": scenario, "action": kind.actions[0]}
        agent_values = {}
        for key, value in applied.items():
            owner, _, name = key.rpartition(".")
            if owner == "env":
                env_values[name] = value
            else:
                agent_values[name if owner == agent else key] = value
        config = TrainingConfig(
            agent, EnvConfig.from_dict(env_values), steps, seed, agent_config=agent_values
        )
        cells.append(Cell(config, episodes, evaluation_seed, applied))
    return list({cell.key: cell for cell in reversed(cells)}.values())[::-1]


def _is_of_another_agent(key: str, agent: str) -> bool:
    owner, _, name = key.rpartition(".")
    return bool(name) and owner in AGENTS and owner != agent
