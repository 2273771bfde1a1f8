"""The pages of docs show what the JSON files beside them hold."""

from pathlib import Path

import pytest

from singulate.bench import Measurement
from singulate.bench.page import fill_page
from singulate.bench.plot import save_plot
from singulate.bench.results import BenchResults, read_results
from singulate.bench.soak import SoakedMemory, SoakResults, read_soak
from singulate.cli import main
from singulate.exceptions import InvalidValueError

DOCS = Path(__file__).parents[2] / "docs"

RESULTS = BenchResults(
    {"processor": "Abacus", "num_cores": 2},
    {
        "env": [
            Measurement("pushes", 1234.5, "pushes/s", "fast"),
            Measurement("gain", 4.125, ""),
            Measurement("peer", None, "steps/s", "not installed: a|b"),
        ],
        "growth": [
            Measurement("map", 2.0, "s", axis="blocks", at=4),
            Measurement("map", 1.0, "s", axis="blocks", at=2),
            Measurement("pushes", 80.0, "1/s", axis="blocks", at=2),
        ],
    },
    {"env": 1.0, "growth": 2.0},
)
SOAKED = SoakResults(
    {}, *(SoakedMemory(what, [5, 10], [9.0, 9.5], [7.0, 7.0], 0.5, 1.0) for what in ("p", "m"))
)


def section(name: str) -> str:
    text = f"before\n<!-- numbers: {name} -->\nold\n<!-- end -->\nafter\n"
    filled = fill_page(text, RESULTS, SOAKED)
    head, tail = f"before\n<!-- numbers: {name} -->\n", "<!-- end -->\nafter\n"
    assert filled.startswith(head) and filled.endswith(tail)
    assert fill_page(filled, RESULTS, SOAKED) == filled
    return filled.removeprefix(head).removesuffix(tail)


@pytest.mark.parametrize("name", ["performance", "learning"])
def test_the_committed_pages_show_the_committed_numbers(name: str) -> None:
    page = (DOCS / f"{name}.md").read_text()
    results = read_results(DOCS / f"{name}.json")
    assert fill_page(page, results, read_soak(DOCS / "memory.json")) == page


def test_measurements_become_a_table() -> None:
    assert section("env").splitlines()[2:5] == [
        "| pushes | 1,234 pushes/s | fast |",
        "| gain | 4.12 |  |",
        "| peer | - | not installed: a/b |",
    ]


def test_points_become_a_table_with_a_column_for_each_curve() -> None:
    assert section("growth").splitlines()[:4] == [
        "| blocks | map [s] | pushes [1/s] |",
        "| ---: | ---: | ---: |",
        "| 2 | 1 | 80 |",
        "| 4 | 2 |  |",
    ]


def test_the_machine_and_the_memory_have_their_places() -> None:
    assert section("machine") == "Processor Abacus, num cores 2.\n"
    assert section("memory").count("| 10 | 9.5 | 7.0 |\n") == 2


def test_a_page_that_asks_for_unknown_numbers_is_refused() -> None:
    with pytest.raises(InvalidValueError, match="fps"):
        section("fps")
    with pytest.raises(InvalidValueError, match="page"):
        fill_page("no numbers", RESULTS, SOAKED)


def test_the_command_fills_a_page_and_draws_the_curves(tmp_path: Path) -> None:
    page, plot, read = (tmp_path / name for name in ("page.md", "plot.png", "bench.json"))
    page.write_text("<!-- numbers: env -->\n<!-- end -->\n")
    read.write_text(RESULTS.to_json())
    (tmp_path / "memory.json").write_text(SOAKED.to_json())
    command = ["bench", "--read", str(read), "--page", str(page), "--plot", str(plot)]
    assert main(command) == 0
    assert "1,234 pushes/s" in page.read_text()
    assert plot.read_bytes().startswith(b"\x89PNG")


def test_a_plot_without_curves_is_refused(tmp_path: Path) -> None:
    results = BenchResults({}, {"env": RESULTS.benchmarks["env"]}, {"env": 1.0})
    with pytest.raises(InvalidValueError, match="curves"):
        save_plot(results, tmp_path / "plot.svg")
