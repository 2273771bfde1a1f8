"""Claim: pretraining on r_Start helps a little, but r_Start is needed all the time."""

from dataclasses import replace

from singulate.experiments.claims.claim import HELD, Claim, Numbers, both, compare
from singulate.experiments.claims.evidence import Evidence, common_steps, late_success
from singulate.rewards.presets import NUM_PRETRAINING_PUSHES

MIN_STEPS = NUM_PRETRAINING_PUSHES * 5 // 4
VARIANTS = {
    "r_Start always": "ppo-fixed-2",
    "pretrained": "ppo-fixed-2-pretrained",
    "r_Dist alone": "ppo-fixed-2-separation",
}


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "pretraining",
        "r_Start for the first 40,000 pushes helps r_Dist a little, but r_Start throughout is"
        " needed for a good policy.",
        "section 5.2, Fig. 4",
        "success over the last tenth of the training pushes of PPO on fixed-2, after equally many;"
        " two comparisons (pretrained above r_Dist alone, r_Start always above pretrained), each"
        " as in the claims of Fig. 3; held where both are, partly where something of them is",
    )
    runs = {name: evidence.finished(each, MIN_STEPS) for name, each in VARIANTS.items()}
    missing = [VARIANTS[name] for name, found in runs.items() if not found]
    if missing:
        needed = f"needs 3 seeds of at least {MIN_STEPS:,} pushes of {', '.join(missing)}"
        return replace(claim, reason=needed)
    steps = common_steps(*runs.values())
    rates = {name: late_success(found, steps) for name, found in runs.items()}
    always, pretrained, alone = rates.values()
    helps, is_needed = compare(pretrained, alone), compare(always, pretrained)
    verdict = both(helps, is_needed)
    return replace(
        claim,
        verdict=verdict,
        numbers=tuple(Numbers.of(name, values) for name, values in rates.items()),
        note=f"pretrained above r_Dist alone: {helps}; r_Start always above pretrained: "
        f"{is_needed}; {steps:,} pushes",
        reason=""
        if verdict == HELD
        else "pretraining leaves one narrow Gaussian at the blocks; whether that spot happens to"
        " part them differs from seed to seed, and little is explored from there",
    )
