"""The claims as a page and as JSON."""

import json
from collections.abc import Sequence
from pathlib import Path

from singulate.checkpoints.durable import replace_file
from singulate.experiments.claims.claim import NOT_MEASURED, Claim
from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.figures.plan import Plan
from singulate.experiments.figures.variants import VARIANTS

HEAD = """# The paper's claims

*Interactive Segmentation using Object Singulation*, claim by claim. This page is written by
`singulate reproduce all` from `training.json`, `ceilings.json`, `fig5.json` and `fig6.json` beside
it. Numbers are medians over seeds with their range; success is a share of 1. The rule of each
verdict is code, in `singulate/experiments/claims/`. With fewer than three seeds nothing is judged.
"""


def write_claims(directory: Path, claims: Sequence[Claim], evidence: Evidence, plan: Plan) -> None:
    """Write ``claims.md`` and ``claims.json``.

    Raises:
        OSError: If they cannot be written.
    """
    rows = [claim.to_dict() for claim in claims]
    about = {"seeds": list(plan.seeds), "ceilings": dict(evidence.ceilings), "claims": rows}
    replace_file(directory / "claims.json", (json.dumps(about, indent=1) + "\n").encode())
    replace_file(directory / "claims.md", claims_page(claims, evidence, plan).encode())


def claims_page(claims: Sequence[Claim], evidence: Evidence, plan: Plan, head: str = HEAD) -> str:
    """The page: a table of verdicts, how each was measured, and which trainings there are."""
    lines = [head, "| claim | in the paper | here | our numbers |", "|---|---|---|---|"]
    for claim in claims:
        numbers = "<br>".join(each.text for each in claim.numbers) or claim.reason
        lines.append(f"| {claim.statement} | {claim.source} | **{claim.verdict}** | {numbers} |")
    lines += ["", "## How each was judged", ""]
    for claim in claims:
        lines += [f"**{claim.key}**: {claim.verdict}. Measure: {claim.measure}."]
        if claim.note:
            lines[-1] += f" Here: {claim.note}."
        if claim.reason:
            why = "Missing" if claim.verdict == NOT_MEASURED else "Likely reason"
            lines[-1] += f" {why}: {claim.reason}."
        lines.append("")
    return "\n".join([*lines, *_trainings(evidence, plan)]) + "\n"


def _trainings(evidence: Evidence, plan: Plan) -> list[str]:
    lines = [
        "## Trainings",
        "",
        f"Seeds asked for: {', '.join(map(str, plan.seeds))}. What is not finished goes on with the"
        " same command. Who is rewarded for the start alone (`start`) has no reason to succeed.",
        "",
        "| training | rewarded by | pushes | seeds finished | success on unseen scenes, by seed |",
        "|---|---|---|---|---|",
    ]
    for name, runs in evidence.runs.items():
        steps = ", ".join(sorted({f"{run['num_steps']:,}" for run in runs})) or "-"
        seeds = ", ".join(str(run["seed"]) for run in runs) or "none yet"
        rates = ", ".join(f"{run['success_rate']:.1%}" for run in runs) or "-"
        reward = VARIANTS[name].env.reward
        lines.append(f"| {name} | {reward} | {steps} | {seeds} | {rates} |")
    if evidence.ceilings:
        lines += ["", "| ceiling of the 10 x 10 grid | scenes | share that some push solves |"]
        lines += ["|---|---|---|"]
    for scenario, ceiling in evidence.ceilings.items():
        low, high = ceiling["interval_95"]
        share = f"{ceiling['share']:.1%} ({low:.1%} to {high:.1%})"
        lines.append(f"| {scenario} | {ceiling['num_scenes']:,} | {share} |")
    return lines
