"""The tables of docs/performance.md, made from measured numbers."""

import re
from collections.abc import Collection, Sequence

from singulate.bench.measurement import Measurement
from singulate.bench.results import BenchResults
from singulate.bench.soak import SoakedMemory, SoakResults
from singulate.exceptions import InvalidValueError

_SECTION = re.compile(r"(<!-- numbers: (?P<name>[\w-]+) -->\n).*?(<!-- end -->)", re.DOTALL)


def check_page(text: str, benchmarks: Collection[str]) -> None:
    """Check that these benchmarks' numbers, the machine and the memory fill all tables of a page.

    Raises:
        InvalidValueError: If there are no tables, or one is to be filled with something else.
    """
    names = [match["name"] for match in _SECTION.finditer(text)]
    if not names:
        raise InvalidValueError("page", "", "Markdown with lines like <!-- numbers: env -->")
    known = (*benchmarks, "machine", "memory")
    for name in names:
        if name not in known:
            raise InvalidValueError("numbers", name, ", ".join(known))


def fill_page(text: str, results: BenchResults, soaked: SoakResults) -> str:
    """Put tables between ``<!-- numbers: NAME -->`` and ``<!-- end -->``.

    Args:
        text: The page, in Markdown.
        results: What a benchmark's name stands for, and ``machine``.
        soaked: What ``memory`` stands for.

    Returns:
        The page with all its numbers replaced; the same numbers give the same page.

    Raises:
        InvalidValueError: If there are no numbers of a name on the page.
    """
    check_page(text, results.benchmarks)
    return _SECTION.sub(lambda m: f"{m[1]}{_section(m['name'], results, soaked)}{m[3]}", text)


def _section(name: str, results: BenchResults, soaked: SoakResults) -> str:
    if name == "machine":
        text = ", ".join(
            f"{key.replace('_', ' ')} {value}" for key, value in results.machine.items()
        )
        return f"{text[0].upper()}{text[1:]}.\n"
    if name == "memory":
        return "\n".join(_soaked(each) for each in (soaked.pushes, soaked.reward_maps))
    measurements = results.benchmarks[name]
    curves = {each.axis: each for each in measurements if each.axis}
    tables = [_curves(axis, measurements) for axis in curves]
    tables.append(_single([each for each in measurements if not each.axis]))
    return "\n".join(tables)


def _single(measurements: list[Measurement]) -> str:
    rows = [(each.name, _quantity(each), each.note) for each in measurements]
    return _table(("what", "value", "how"), rows, "l r l")


def _curves(axis: str, measurements: list[Measurement]) -> str:
    """One row for each point of an axis, one column for each curve."""
    points = {(each.at, each.name): each for each in measurements if each.axis == axis}
    names = list(dict.fromkeys(name for _, name in points))
    units = {name: each.unit for (_, name), each in points.items()}
    head = (axis, *(f"{name} [{units[name]}]" if units[name] else name for name in names))
    rows = [
        (
            f"{at:g}",
            *(_number(found.value) if (found := points.get((at, n))) else "" for n in names),
        )
        for at in sorted({at for at, _ in points if at is not None})
    ]
    return _table(head, rows, " ".join("r" * len(head)))


def _soaked(memory: SoakedMemory) -> str:
    rows = [
        (f"{done:,}", f"{worker:.1f}", f"{parent:.1f}")
        for done, worker, parent in zip(
            memory.num_done, memory.worker_mib, memory.parent_mib, strict=True
        )
    ]
    head = (memory.what, "worker [MiB]", "parent [MiB]")
    return _table(head, rows, "r r r")


def _table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]], alignment: str) -> str:
    rule = ["---:" if each == "r" else "---" for each in alignment.split()]
    lines = [head, tuple(rule), *rows]
    return "".join(f"| {' | '.join(cell.replace('|', '/') for cell in line)} |\n" for line in lines)


def _quantity(measurement: Measurement) -> str:
    unit = "" if measurement.value is None else measurement.unit
    return f"{_number(measurement.value)} {unit}".strip()


def _number(value: float | None) -> str:
    """Three digits."""
    if value is None:
        return "-"
    return f"{value:,.0f}" if abs(value) >= 100.0 else f"{value:.3g}"
