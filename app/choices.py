"""Names that the page offers; the server may not import the packages that define them."""

AGENTS = ("dqn", "ppo", "spatial", "multimodal-ppo")
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
