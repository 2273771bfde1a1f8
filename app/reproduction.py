"""What `singulate reproduce` has left: the paper's figures and a verdict on each claim."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from singulate.exceptions import SingulateError
from singulate.experiments.claims.claim import Numbers
from singulate.paths import figures_directory

MAX_BYTES = 10_000_000


@dataclass(frozen=True)
class Claim:
    """One claim of the paper.

    Attributes:
        statement: What the paper says.
        source: Where.
        verdict: ``held``, ``partly``, ``not held`` or ``not measured``.
        numbers: Our numbers, one line each.
        reason: The likely reason where it does not hold, or what is missing.
    """

    statement: str
    source: str
    verdict: str
    numbers: tuple[str, ...]
    reason: str


@dataclass(frozen=True)
class Reproduction:
    """The figures that are there, and the claims.

    Attributes:
        figures: PNG files by their numbers in the paper, and ``ideas`` for those of its section 6.
        claims: In the paper's order; none where they have not been judged.
    """

    figures: dict[str, Path]
    claims: tuple[Claim, ...]


def read_reproduction(directory: Path | None = None) -> Reproduction:
    """Read the directory that ``singulate reproduce --out`` has written; empty where there is none.

    Args:
        directory: By default the one that comes with the repository.

    Raises:
        SingulateError: If the claims cannot be read.
    """
    directory = directory or figures_directory()
    pictures = [*sorted(directory.glob("fig*.png")), *directory.glob("ideas.png")]
    figures = {picture.stem.removeprefix("fig"): picture for picture in pictures}
    path = directory / "claims.json"
    if not path.is_file():
        return Reproduction(figures, ())
    try:
        entries = json.loads(path.read_bytes()[:MAX_BYTES])["claims"]
        claims = tuple(map(_claim, entries))
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise SingulateError(f"{path}: not the claims of 'singulate reproduce' ({error})") from None
    return Reproduction(figures, claims)


def _claim(entry: Mapping[str, Any]) -> Claim:
    return Claim(
        str(entry["statement"]),
        str(entry["source"]),
        str(entry["verdict"]),
        tuple(Numbers(str(each["name"]), tuple(each["values"])).text for each in entry["numbers"]),
        str(entry["reason"]),
    )
