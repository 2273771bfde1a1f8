"""What `singulate bench --json` prints, read back."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import msgspec

from singulate.bench.measurement import Measurement
from singulate.exceptions import InvalidValueError

ResultsT = TypeVar("ResultsT")


@dataclass(frozen=True)
class BenchResults:
    """Numbers and the machine that they were measured on.

    Attributes:
        machine: See `describe_machine`.
        benchmarks: Measurements in the order in which they were taken, by benchmark.
        seconds: How long each benchmark took [s].
    """

    machine: dict[str, str | int | float]
    benchmarks: dict[str, list[Measurement]]
    seconds: dict[str, float]

    def to_json(self) -> str:
        """Indented, so that a committed file shows what changed."""
        return msgspec.json.format(msgspec.json.encode(self), indent=2).decode()

    @property
    def curves(self) -> Mapping[tuple[str, str], list[Measurement]]:
        """Points of all benchmarks by axis and by curve, in order along the axis."""
        found: dict[tuple[str, str], list[Measurement]] = {}
        for measurements in self.benchmarks.values():
            for each in measurements:
                if each.axis and each.at is not None and each.value is not None:
                    found.setdefault((each.axis, each.name), []).append(each)
        return {key: sorted(points, key=lambda p: p.at or 0.0) for key, points in found.items()}


def read_results(path: Path) -> BenchResults:
    """Read a file that `singulate bench --json` wrote.

    Raises:
        InvalidValueError: If it is no such file.
        OSError: If it cannot be read.
    """
    return decode_file(path, BenchResults, "read", "singulate bench --json")


def decode_file(path: Path, kind: type[ResultsT], key: str, command: str) -> ResultsT:
    """Read a file that a command wrote as JSON.

    Args:
        path: The file.
        kind: What it holds.
        key: What the user calls it.
        command: The command.

    Raises:
        InvalidValueError: If it is no such file.
        OSError: If it cannot be read.
    """
    try:
        return msgspec.json.decode(path.read_bytes(), type=kind)
    except msgspec.DecodeError as error:
        raise InvalidValueError(key, str(path), f"the output of {command} ({error})") from None
