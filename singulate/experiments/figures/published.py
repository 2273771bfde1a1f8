"""The numbers of an earlier reproduction, from its small files, where its trainings are gone."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

from singulate.experiments.cell import Cell

TRAININGS_NAME = "training.json"


@dataclass(frozen=True)
class Published:
    """What a directory of figures tells of trainings that need not be repeated.

    Attributes:
        summaries: Summaries of trainings (`summarise`) by `Cell.key`, which says that the very
            same training and evaluation are meant.
        figures: Raw numbers of figures by name.
    """

    summaries: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    figures: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)

    @classmethod
    def read(cls, directory: Path, figures: Sequence[str]) -> Self:
        """All that can be read there; a file that is missing or damaged tells nothing."""
        data = {name: _read_object(directory / f"{name}.json") for name in figures}
        sources = [_read_object(directory / TRAININGS_NAME)]
        sources += [runs for each in data.values() if isinstance(runs := each.get("runs"), dict)]
        lists = [runs for variants in sources for runs in variants.values()]
        runs = [run for each in lists if isinstance(each, list) for run in each]
        summaries = {run["key"]: run for run in runs if isinstance(run, dict) and "key" in run}
        return cls(summaries, {name: values for name, values in data.items() if values})

    def has(self, cells: Sequence[Cell]) -> bool:
        """Whether it tells of all these trainings."""
        return all(cell.key in self.summaries for cell in cells)


def _read_object(path: Path) -> dict[str, Any]:
    try:
        content = json.loads(path.read_bytes())
    except (OSError, ValueError):
        return {}
    return content if isinstance(content, dict) else {}
