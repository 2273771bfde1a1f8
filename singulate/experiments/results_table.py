"""Results of cells as a table: CSV for people, Parquet for programs."""

import csv
import io
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from singulate.checkpoints.durable import replace_file
from singulate.evaluation.wilson import wilson_interval
from singulate.experiments.cell import Cell, CellResult

COLUMNS: dict[str, str] = {
    "agent": "string",
    "scenario": "string",
    "settings": "string",
    "seed": "int64",
    "num_steps": "int64",
    "evaluation_seed": "int64",
    "num_episodes": "int64",
    "num_successes": "int64",
    "success_rate": "float64",
    "success_low": "float64",
    "success_high": "float64",
    "mean_reward": "float64",
    "mean_pushes": "float64",
    "weights_sha256": "string",
}
"""Names and Arrow types; ``success_low`` to ``success_high`` is the 95 % Wilson interval.

No times: equal experiments have equal tables, byte for byte, wherever they ran.
"""

Row = dict[str, Any]


def table_row(cell: Cell, result: CellResult) -> Row:
    """One cell as a row; `settings` is JSON."""
    low, high = wilson_interval(result.num_successes, result.num_episodes)
    return {
        "agent": cell.training.agent,
        "scenario": cell.training.env.scenario,
        "settings": json.dumps(dict(cell.settings), sort_keys=True),
        "seed": cell.training.seed,
        "num_steps": result.num_steps,
        "evaluation_seed": cell.evaluation_seed,
        "num_episodes": result.num_episodes,
        "num_successes": result.num_successes,
        "success_rate": result.num_successes / result.num_episodes,
        "success_low": low,
        "success_high": high,
        "mean_reward": result.mean_reward,
        "mean_pushes": result.mean_pushes,
        "weights_sha256": result.weights_sha256,
    }


def write_csv(path: Path, rows: Sequence[Row]) -> None:
    """Write the table as a whole or not at all.

    Raises:
        OSError: If it cannot be written.
    """
    text = io.StringIO()
    writer = csv.DictWriter(text, list(COLUMNS), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    replace_file(path, text.getvalue().encode())


def write_parquet(path: Path, rows: Sequence[Row]) -> None:
    """Write the table as a whole or not at all.

    Raises:
        OSError: If it cannot be written.
    """
    from arro3.core import Array, DataType, Table
    from arro3.io import write_parquet as write_arrow

    columns: dict[str, Any] = {
        name: Array([row[name] for row in rows], type=getattr(DataType, kind)())
        for name, kind in COLUMNS.items()
    }
    data = io.BytesIO()
    write_arrow(Table.from_pydict(columns), data)
    replace_file(path, data.getvalue())


def pooled(rows: Sequence[Row]) -> list[Row]:
    """Rows of equal agent, scenario and settings in one: all episodes of all seeds.

    The interval is that of the episodes; how far seeds differ, single rows tell.
    """
    groups: dict[tuple[str, ...], list[Row]] = {}
    for row in rows:
        groups.setdefault((row["agent"], row["scenario"], row["settings"]), []).append(row)
    summary = []
    for (agent, scenario, settings), members in groups.items():
        num_successes = sum(row["num_successes"] for row in members)
        num_episodes = sum(row["num_episodes"] for row in members)
        low, high = wilson_interval(num_successes, num_episodes)
        summary.append(
            {
                "agent": agent,
                "scenario": scenario,
                "settings": settings,
                "num_seeds": len(members),
                "success_rate": num_successes / num_episodes,
                "success_low": low,
                "success_high": high,
                "rates": [row["success_rate"] for row in members],
            }
        )
    return summary
