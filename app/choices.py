"""Names that the page offers, out of many more that can be typed."""

USUAL_PUSHES = {
    "spatial": 2_000,
    "multimodal-ppo": 20_000,
    "fourier-ppo": 20_000,
    "mixture-ppo": 20_000,
    "dqn": 20_000,
    "sac": 20_000,
    "td3": 20_000,
    "ppo": 60_000,
    "trpo": 60_000,
}
"""Agents that can be trained, the fastest learner first, and their usual lengths of training."""

AGENTS = tuple(USUAL_PUSHES)
"""Agents that can be trained."""

SCENARIOS = (
    *(f"fixed-{count}" for count in (2, 3)),
    *(f"random-{count}" for count in range(2, 9)),
    *(f"cluster-{count}" for count in range(3, 11)),
    "random-2+random-3",
)
"""Scenarios that can be put on the table."""

MAX_SEED = 2**31 - 1
MAX_TIMESTEPS = 100_000_000
MIN_SPEED, MAX_SPEED = 0.1, 8.0
