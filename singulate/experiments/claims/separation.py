"""Claim: a DQN copes with r = r_Dist, where PPO does not."""

from dataclasses import replace

from singulate.experiments.claims.claim import HELD, Claim, Numbers, at_least, at_most, both
from singulate.experiments.claims.evidence import Evidence, common_steps, success_rates

MIN_STEPS = {"dqn": 10_000, "ppo": 30_000}


def judge(evidence: Evidence) -> Claim:
    """See the module."""
    claim = Claim(
        "separation",
        "With r = r_Dist alone a DQN finds a good policy where PPO does not.",
        "section 5.4",
        "success on 1,000 episodes of fixed-2; the DQN reaches a median of 90 % (partly 50 %), PPO"
        " stays at 10 % at most (partly 50 %); held where both are",
    )
    runs = {a: evidence.finished(f"{a}-fixed-2-separation", n) for a, n in MIN_STEPS.items()}
    if not all(runs.values()):
        missing = ", ".join(agent for agent, found in runs.items() if not found)
        return replace(claim, reason=f"needs 3 seeds of {missing}")
    dqn, ppo = success_rates(runs["dqn"]), success_rates(runs["ppo"])
    copes, fails = at_least(dqn, 0.9, 0.5), at_most(ppo, 0.1, 0.5)
    verdict = both(copes, fails)
    return replace(
        claim,
        verdict=verdict,
        numbers=(Numbers.of("DQN, success", dqn), Numbers.of("PPO, success", ppo)),
        note=f"DQN copes: {copes}, {common_steps(runs['dqn']):,} pushes; PPO does not: {fails}, "
        f"{common_steps(runs['ppo']):,} pushes",
        reason=""
        if verdict == HELD
        else "on one fixed scene a few lucky pushes are enough to show either agent where to go",
    )
