import json
from pathlib import Path
from typing import Any

import pytest

from singulate.experiments.claims.claim import HELD, NOT_HELD, NOT_MEASURED, PARTLY
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.registry import judge_ideas
from singulate.experiments.figures.ideas import LINES, page
from singulate.experiments.figures.plan import Plan
from singulate.experiments.figures.published import Published


def runs(*rates: float, num_steps: int = 20_000) -> list[dict[str, Any]]:
    """Trainings with constant success."""
    curve = {"steps": [num_steps / 2, num_steps], "reward": [0.0, 0.0]}
    return [
        {
            "seed": seed,
            "num_steps": num_steps,
            "success_rate": rate,
            "curve": {**curve, "success": [rate, rate]},
        }
        for seed, rate in enumerate(rates)
    ]


def trained(**changes: list[dict[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    """Every line of the figure with three seeds; changes by agent."""
    return {
        name: next(
            (found for agent, found in changes.items() if name == f"{agent}-ppo-random-2"),
            runs(0.03, 0.02, 0.01),
        )
        for name in LINES
    }


@pytest.mark.parametrize("idea", ["mixture", "fourier"])
@pytest.mark.parametrize(
    ("rates", "expected"),
    [((0.8, 0.9, 1.0), HELD), ((0.1, 0.6, 1.0), PARTLY), ((0.0, 0.1, 1.0), NOT_HELD)],
)
def test_an_idea_is_judged_by_its_success(
    idea: str, rates: tuple[float, ...], expected: str
) -> None:
    claims = judge_ideas(Evidence(trained(**{idea: runs(*rates)})))
    claim = next(each for each in claims if each.key == idea)
    assert claim.verdict == expected
    medians = {numbers.name: numbers.median for numbers in claim.numbers}
    assert medians["success"] == medians["mean success while learning"] == sorted(rates)[1]
    assert medians["success of the paper's PPO"] == 0.02
    assert medians["success of one Gaussian with the same network"] == 0.02
    assert bool(claim.reason) == (expected != HELD)


@pytest.mark.parametrize("few", [runs(0.9, 0.9), runs(0.9, 0.9, 0.9, num_steps=2_048)])
def test_too_little_training_is_no_measurement(few: list[dict[str, Any]]) -> None:
    mixture = next(
        claim for claim in judge_ideas(Evidence(trained(mixture=few))) if claim.key == "mixture"
    )
    assert mixture.verdict == NOT_MEASURED
    assert "mixture-ppo-random-2" in mixture.reason
    assert "ppo-random-2-short" not in mixture.reason


def test_the_page_has_a_verdict_on_each_idea_and_every_training() -> None:
    text = page({"runs": trained(fourier=runs(0.9, 0.95, 0.99))}, Plan())
    assert text.startswith("# The paper's ideas for future work")
    assert text.count("**held**") == 1
    assert text.count("**not held**") == len(judge_ideas(Evidence({}))) - 1
    assert "success: 0.95 (0.9 to 0.99, 3 seeds)" in text
    assert all(f"| {name} | paper | 20,000 | 0, 1, 2 |" in text for name in LINES)


def test_trainings_in_a_figures_own_file_are_known(tmp_path: Path) -> None:
    run = {"key": "abc", "num_steps": 20_000}
    (tmp_path / "ideas.json").write_text(json.dumps({"runs": {"variant": [run]}}))
    (tmp_path / "fig1.json").write_text('{"runs": 3}')
    published = Published.read(tmp_path, ("ideas", "fig1", "fig2"))
    assert published.summaries == {"abc": run}
    assert set(published.figures) == {"ideas", "fig1"}
