"""The trainings behind the figures and claims, by name."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from singulate.envs import EnvConfig
from singulate.experiments.cell import Cell
from singulate.experiments.figures.plan import Plan
from singulate.training.config import TrainingConfig


@dataclass(frozen=True)
class Variant:
    """One way of setting the task, trained once a seed.

    Attributes:
        label: Name for people.
        agent: Kind of agent, with its defaults (Table 1 for PPO) but for `settings`.
        total_timesteps: Pushes of the training in full.
        env: The task.
        is_length_given: Whether the paper gives the length, so that it stays as it is.
        is_coded: Whether the agent sees an autoencoder's code of the distance map.
        settings: Settings of the agent by name.
    """

    label: str
    agent: str
    total_timesteps: int
    env: EnvConfig
    is_length_given: bool = False
    is_coded: bool = False
    settings: Mapping[str, Any] = field(default_factory=dict)

    def cells(self, plan: Plan) -> list[Cell]:
        """Its trainings, one a seed."""
        steps = plan.steps_of(self.total_timesteps, self.is_length_given)
        return [
            Cell(
                TrainingConfig(self.agent, self.env, steps, seed, self.settings),
                plan.episodes,
                plan.evaluation_seed,
                autoencoder=plan.autoencoder if self.is_coded else None,
            )
            for seed in plan.seeds
        ]


PPO_STEPS = 60_000
"""As far as the paper's Fig. 6 goes."""
DQN_STEPS = 20_000
IDEAS_STEPS = 20_000
"""Of the paper's ideas for future work: as far as ``multimodal-ppo`` needs on ``random-2``."""

VARIANTS: dict[str, Variant] = {
    "ppo-fixed-2": Variant("proposed", "ppo", PPO_STEPS, EnvConfig("fixed-2")),
    "ppo-fixed-2-mask": Variant(
        "binary mask", "ppo", PPO_STEPS, EnvConfig("fixed-2", observation="mask")
    ),
    "ppo-fixed-2-start-end": Variant(
        "start and end", "ppo", PPO_STEPS, EnvConfig("fixed-2", action="start_end")
    ),
    "ppo-fixed-2-separation": Variant(
        "r_Dist alone", "ppo", PPO_STEPS, EnvConfig("fixed-2", reward="separation")
    ),
    "ppo-fixed-2-pretrained": Variant(
        "pretrained", "ppo", PPO_STEPS, EnvConfig("fixed-2", reward="start_then_separation"), True
    ),
    "ppo-fixed-2-start": Variant(
        "r_Start and r_Inside", "ppo", PPO_STEPS, EnvConfig("fixed-2", reward="start"), True
    ),
    "ppo-fixed-2-code": Variant(
        "learned code", "ppo", PPO_STEPS, EnvConfig("fixed-2"), is_coded=True
    ),
    "ppo-random-2": Variant("PPO", "ppo", PPO_STEPS, EnvConfig("random-2")),
    "dqn-fixed-2-start": Variant(
        "r_Start and r_Inside",
        "dqn",
        4_000,
        EnvConfig("fixed-2", action="grid", reward="start"),
        True,
    ),
    "dqn-fixed-2-separation": Variant(
        "r_Dist alone", "dqn", 10_000, EnvConfig("fixed-2", action="grid", reward="separation")
    ),
    "dqn-random-2": Variant("DQN", "dqn", DQN_STEPS, EnvConfig("random-2", action="grid")),
    "dqn-random-2-code": Variant(
        "learned code", "dqn", DQN_STEPS, EnvConfig("random-2", action="grid"), is_coded=True
    ),
    "dqn-random-3": Variant("DQN", "dqn", DQN_STEPS, EnvConfig("random-3", action="grid")),
    "trpo-random-2": Variant("TRPO", "trpo", PPO_STEPS, EnvConfig("random-2")),
    "ppo-random-2-short": Variant("one Gaussian", "ppo", IDEAS_STEPS, EnvConfig("random-2")),
    "mixture-ppo-1-random-2": Variant(
        "one Gaussian, same network",
        "mixture-ppo",
        IDEAS_STEPS,
        EnvConfig("random-2"),
        settings={"num_components": 1},
    ),
    "mixture-ppo-random-2": Variant(
        "mixture of Gaussians", "mixture-ppo", IDEAS_STEPS, EnvConfig("random-2")
    ),
    "fourier-ppo-random-2": Variant(
        "Fourier density", "fourier-ppo", IDEAS_STEPS, EnvConfig("random-2")
    ),
    "multimodal-ppo-random-2": Variant(
        "cells", "multimodal-ppo", IDEAS_STEPS, EnvConfig("random-2")
    ),
}
"""Every training of the reproduction; a new one is one entry."""
