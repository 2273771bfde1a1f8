"""The numbers that claims are judged by."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from singulate.experiments.figures.summaries import Summaries, Summary

MIN_SEEDS = 3
"""Fewer finished seeds are no measurement."""


@dataclass(frozen=True)
class Evidence:
    """What a reproduction has measured; anything may be missing.

    Attributes:
        runs: Summaries of trainings by variant.
        figures: Raw numbers of figures by name.
        ceilings: Share of scenes that the agents' discrete pushes can solve, by scenario, as
            `Ceiling.to_dict`.
    """

    runs: Summaries
    figures: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    ceilings: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)

    def finished(self, variant: str, min_steps: int = 0) -> list[Summary]:
        """Trainings of a variant that are long enough; none where seeds are too few."""
        runs = [run for run in self.runs.get(variant, []) if run["num_steps"] >= min_steps]
        return runs if len(runs) >= MIN_SEEDS else []

    def seeds_of(self, figure: str) -> list[Mapping[str, Any]]:
        """What a figure has measured of each seed; none where seeds are too few."""
        seeds: list[Mapping[str, Any]] = list(self.figures.get(figure, {}).get("seeds", []))
        return seeds if len(seeds) >= MIN_SEEDS else []


def success_rates(runs: Sequence[Summary]) -> list[float]:
    """Success on unseen scenes, one a seed."""
    return [run["success_rate"] for run in runs]


def mean_success_while_learning(runs: Sequence[Summary], num_steps: int) -> list[float]:
    """Mean success of the pushes up to `num_steps` of a training: high where learning is fast."""
    return [_curve_mean(run, 0, num_steps) for run in runs]


def late_success(runs: Sequence[Summary], num_steps: int) -> list[float]:
    """Mean success of the last tenth of the pushes up to `num_steps` of a training."""
    return [_curve_mean(run, 0.9 * num_steps, num_steps) for run in runs]


def common_steps(*groups: Sequence[Summary]) -> int:
    """Pushes that all trainings have made."""
    return min(int(run["num_steps"]) for group in groups for run in group)


def _curve_mean(run: Summary, after: float, up_to: float) -> float:
    curve = run["curve"]
    rates = [r for s, r in zip(curve["steps"], curve["success"], strict=True) if after < s <= up_to]
    return float(np.mean(rates)) if rates else 0.0
