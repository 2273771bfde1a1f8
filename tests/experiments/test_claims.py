import json
from pathlib import Path
from typing import Any

import pytest

from singulate.experiments.claims.claim import HELD, NOT_HELD, NOT_MEASURED, PARTLY, Claim, Numbers
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.registry import CLAIMS, judge_all
from singulate.experiments.claims.table import claims_page, write_claims
from singulate.experiments.figures.plan import Plan

CEILINGS = {
    name: {"share": share, "num_scenes": 1000, "interval_95": [share - 0.01, share + 0.01]}
    for name, share in {"random-2": 0.97, "random-3": 0.83}.items()
}


def runs(num_steps: int, *rates: float) -> list[dict[str, Any]]:
    """Trainings whose success rises evenly to the given rates."""
    points = range(1, 31)
    return [
        {
            "seed": seed,
            "num_steps": num_steps,
            "success_rate": rate,
            "curve": {
                "steps": [num_steps * i / 30 for i in points],
                "success": [rate * i / 30 for i in points],
                "reward": [1000 * rate * i / 30 for i in points],
            },
        }
        for seed, rate in enumerate(rates)
    ]


def verdict(key: str, evidence: Evidence) -> str:
    return next(claim for claim in judge_all(evidence) if claim.key == key).verdict


@pytest.mark.parametrize(
    ("key", "baseline"), [("state", "mask"), ("action", "start-end"), ("reward", "separation")]
)
@pytest.mark.parametrize(
    ("theirs", "expected"),
    [
        ((0.1, 0.2, 0.3), HELD),
        ((0.1, 0.2, 0.95), PARTLY),
        ((0.9, 0.95, 1.0), NOT_HELD),
        ((0.1, 0.2), NOT_MEASURED),
    ],
)
def test_faster_learning(key: str, baseline: str, theirs: tuple[float, ...], expected: str) -> None:
    trained = {
        "ppo-fixed-2": runs(60_000, 0.8, 0.85, 0.9),
        f"ppo-fixed-2-{baseline}": runs(60_000, *theirs),
    }
    assert verdict(key, Evidence(trained)) == expected


def test_learning_is_compared_over_the_same_pushes() -> None:
    trained = {
        "ppo-fixed-2": runs(60_000, 0.8, 0.8, 0.8),
        "ppo-fixed-2-mask": runs(30_000, 0.5, 0.5, 0.5),
    }
    claim = judge_all(Evidence(trained))[0]
    assert (claim.key, claim.note) == ("state", "first 30,000 pushes")
    assert claim.verdict == NOT_HELD  # the others had risen further by then
    assert [numbers.median for numbers in claim.numbers] == pytest.approx([0.2133, 0.2583])


@pytest.mark.parametrize(
    ("rates", "expected"),
    [((0.5, 0.9, 1.0), HELD), ((0.5, 0.6, 1.0), PARTLY), ((0.0, 0.1, 1.0), NOT_HELD)],
)
def test_ppo_on_the_fixed_scene(rates: tuple[float, ...], expected: str) -> None:
    assert verdict("ppo-fixed-2", Evidence({"ppo-fixed-2": runs(60_000, *rates)})) == expected
    short = Evidence({"ppo-fixed-2": runs(2_048, *rates)})
    assert verdict("ppo-fixed-2", short) == NOT_MEASURED


@pytest.mark.parametrize(
    ("rates", "expected"),
    [((0.0, 0.05, 0.3), HELD), ((0.0, 0.3, 0.3), PARTLY), ((0.6, 0.7, 0.8), NOT_HELD)],
)
@pytest.mark.parametrize(
    ("key", "variant"), [("ppo-random-2", "ppo-random-2"), ("trpo", "trpo-random-2")]
)
def test_gaussians_on_random_scenes(
    key: str, variant: str, rates: tuple[float, ...], expected: str
) -> None:
    assert verdict(key, Evidence({variant: runs(60_000, *rates)})) == expected
    assert verdict(key, Evidence({variant: runs(20_000, *rates)})) == NOT_MEASURED
    assert verdict(key, Evidence({variant: runs(60_000, *rates[:2])})) == NOT_MEASURED


@pytest.mark.parametrize(
    ("two", "three", "expected"),
    [(0.9, 0.76, HELD), (0.9, 0.5, PARTLY), (0.3, 0.76, PARTLY), (0.3, 0.2, NOT_HELD)],
)
def test_dqn_is_judged_by_what_its_grid_allows(two: float, three: float, expected: str) -> None:
    trained = {
        "dqn-random-2": runs(20_000, two, two, two),
        "dqn-random-3": runs(20_000, three, three, three),
    }
    assert verdict("dqn-random", Evidence(trained, ceilings=CEILINGS)) == expected
    assert verdict("dqn-random", Evidence(trained)) == NOT_MEASURED


def test_a_reason_says_of_a_training_only_what_its_curve_shows() -> None:
    rising = {f"dqn-{name}": runs(20_000, 0.4, 0.4, 0.4) for name in CEILINGS}
    flat = {f"dqn-{name}": runs(20_000, 0.4, 0.4, 0.4) for name in CEILINGS}
    for run in [run for group in flat.values() for run in group]:
        run["curve"]["success"] = [0.4] * 30
    for trained, expected in ((rising, True), (flat, False)):
        claims = judge_all(Evidence(trained, ceilings=CEILINGS))
        reason = next(claim.reason for claim in claims if claim.key == "dqn-random")
        assert ("still rises" in reason) == expected


@pytest.mark.parametrize(
    ("always", "pretrained", "alone", "expected"),
    [(0.9, 0.5, 0.1, HELD), (0.9, 0.1, 0.5, PARTLY), (0.1, 0.5, 0.9, NOT_HELD)],
)
def test_pretraining(always: float, pretrained: float, alone: float, expected: str) -> None:
    trained = {
        "ppo-fixed-2": runs(60_000, always, always, always),
        "ppo-fixed-2-pretrained": runs(60_000, pretrained, pretrained, pretrained),
        "ppo-fixed-2-separation": runs(60_000, alone, alone, alone),
    }
    assert verdict("pretraining", Evidence(trained)) == expected
    before_its_end = {name: runs(40_000, 0.1, 0.2, 0.3) for name in trained}
    assert verdict("pretraining", Evidence(before_its_end)) == NOT_MEASURED


@pytest.mark.parametrize(
    ("dqn", "ppo", "expected"), [(1.0, 0.0, HELD), (1.0, 0.9, PARTLY), (0.1, 0.9, NOT_HELD)]
)
def test_separation_alone(dqn: float, ppo: float, expected: str) -> None:
    trained = {
        "dqn-fixed-2-separation": runs(10_000, dqn, dqn, dqn),
        "ppo-fixed-2-separation": runs(60_000, ppo, ppo, ppo),
    }
    assert verdict("separation", Evidence(trained)) == expected


@pytest.mark.parametrize(
    ("ppo", "dqn", "expected"),
    [
        ((0.9, 0.9, 1.0), (0.9, 0.9, 1.0), HELD),
        ((0.9, 0.9, 1.0), (0.1, 0.1, 0.2), PARTLY),
        ((0.6, 0.9, 1.0), (0.6, 0.9, 1.0), PARTLY),
        ((0.1, 0.1, 0.2), (0.1, 0.1, 0.2), NOT_HELD),
    ],
)
def test_a_smaller_state(ppo: tuple[float, ...], dqn: tuple[float, ...], expected: str) -> None:
    trained = {
        "ppo-fixed-2": runs(60_000, 0.6, 0.7, 0.8),
        "dqn-random-2": runs(20_000, 0.6, 0.7, 0.8),
        "ppo-fixed-2-code": runs(60_000, *ppo),
    }
    incomplete = next(c for c in judge_all(Evidence(trained)) if c.key == "autoencoder")
    assert incomplete.verdict == NOT_MEASURED
    assert incomplete.reason == "needs 3 seeds of dqn-random-2-code"
    trained["dqn-random-2-code"] = runs(20_000, *dqn)
    assert verdict("autoencoder", Evidence(trained)) == expected


def start_figures(correlation: float, early: float, late: float, x: float) -> dict[str, Any]:
    moments = [
        {"step": step, "mean_m": [x, 0.0], "deviation_m": [spread, 0.1], "share_inside": 0.2}
        for step, spread in ((20_000, early), (40_000, early), (60_000, late))
    ]
    values = {"num_steps": 4_000, "correlation": correlation, "share_of_best": 1.0}
    return {"fig5": {"seeds": [values] * 3}, "fig6": {"seeds": [{"moments": moments}] * 3}}


@pytest.mark.parametrize(
    ("figures", "expected"),
    [
        (start_figures(0.95, 0.4, 0.1, 0.0), (HELD, HELD)),
        (start_figures(0.95, 0.4, 0.4, 0.5), (PARTLY, NOT_HELD)),
        (start_figures(0.5, 0.1, 0.1, 0.0), (NOT_HELD, HELD)),
        ({}, (NOT_MEASURED, NOT_MEASURED)),
    ],
)
def test_values_and_starts(figures: dict[str, Any], expected: tuple[str, str]) -> None:
    evidence = Evidence({}, figures)
    assert (verdict("dqn-values", evidence), verdict("unimodality", evidence)) == expected


def test_without_evidence_nothing_is_judged_and_the_reason_is_given() -> None:
    claims = judge_all(Evidence({}))
    assert len(claims) == len(CLAIMS) == len({claim.key for claim in claims})
    assert {claim.verdict for claim in claims} == {NOT_MEASURED}
    assert all(claim.reason for claim in claims)


def test_the_table_says_what_the_json_says(tmp_path: Path) -> None:
    trained = {"ppo-fixed-2": runs(60_000, 0.5, 0.6, 0.7), "ppo-random-2": []}
    evidence = Evidence(trained, ceilings=CEILINGS)
    claims, plan = judge_all(evidence), Plan()
    write_claims(tmp_path, claims, evidence, plan)
    page = (tmp_path / "claims.md").read_text()
    assert page == claims_page(claims, evidence, plan)
    saved = json.loads((tmp_path / "claims.json").read_text())
    assert [row["verdict"] for row in saved["claims"]] == [claim.verdict for claim in claims]
    assert "success: 0.6 (0.5 to 0.7, 3 seeds)" in page
    assert "| ppo-random-2 | paper | - | none yet | - |" in page
    assert "| random-3 | 1,000 | 83.0% (82.0% to 84.0%) |" in page
    assert page.count("**not measured**") == len(claims) - 1


def test_a_claim_is_plain_json() -> None:
    claim = Claim("k", "s", "p", "m", HELD, (Numbers.of("n", [1.0, 2.00001, 9.0]),))
    assert json.loads(json.dumps(claim.to_dict()))["numbers"][0]["median"] == 2.0
