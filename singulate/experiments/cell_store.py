"""Where the cells of experiments lie: a finished one is never computed again."""

import json
from pathlib import Path

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.checkpoints.durable import replace_file
from singulate.exceptions import RunError
from singulate.experiments.cell import Cell, CellResult, CellTask
from singulate.runs import RunDirectory, read_status
from singulate.runs.json_text import parse_json_object


class CellStore:
    """A directory of cells, each with its run and, once it is finished, ``result.json``.

    Only one process writes results: the one that hands out the tasks.

    Args:
        directory: Where they lie; made when the first one is computed.
    """

    def __init__(self, directory: Path) -> None:
        self._directory = directory.absolute()

    def run_dir(self, cell: Cell) -> Path:
        """Run directory of a cell's training."""
        return self._directory / cell.name / "run"

    def autoencoder_dir(self, config: AutoencoderConfig) -> Path:
        """Directory of an autoencoder that cells share."""
        return self._directory / f"autoencoder-{config.key}"

    def task(self, cell: Cell) -> CellTask:
        """What computes a cell here."""
        config, run_dir = cell.autoencoder, str(self.run_dir(cell))
        if config is None:
            return CellTask(cell, run_dir)
        return CellTask(cell, run_dir, str(self.autoencoder_dir(config)))

    def read(self, cell: Cell) -> CellResult | None:
        """The result of a cell; None where it is unfinished or the file is damaged."""
        try:
            content = parse_json_object(self._result_path(cell).read_bytes())
            result = CellResult.from_dict(content["result"])
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return result if content.get("key") == cell.key else None

    def has_run(self, cell: Cell) -> bool:
        """Whether a cell is finished and its run can be read from here.

        Without a file system that all nodes of a cluster share, a run stays where it was made.
        """
        return self.read(cell) is not None and RunDirectory(self.run_dir(cell)).is_run

    def write(self, cell: Cell, result: CellResult) -> None:
        """Record that a cell is finished.

        Raises:
            OSError: If it cannot be written.
        """
        content = {
            "key": cell.key,
            "training": cell.training.to_dict(),
            "evaluation_seed": cell.evaluation_seed,
            "result": result.to_dict(),
        }
        path = self._result_path(cell)
        path.parent.mkdir(parents=True, exist_ok=True)
        replace_file(path, (json.dumps(content, indent=2) + "\n").encode())

    def num_steps(self, cell: Cell) -> int:
        """Pushes that a cell's training has done, as far as can be seen from here."""
        try:
            num_steps = read_status(self.run_dir(cell)).num_steps
        except RunError:  # it has not begun, or runs where its files cannot be seen
            return 0
        return min(num_steps, cell.training.total_timesteps)

    def _result_path(self, cell: Cell) -> Path:
        return self._directory / cell.name / "result.json"
