"""The reward functions that a user can ask for by name."""

from singulate.exceptions import InvalidValueError
from singulate.rewards.composite import RewardFunction

K_START = 300.0
K_DISTANCE = 1000.0
K_INSIDE = -100.0
K_SUCCESS = 1000.0

NUM_PRETRAINING_PUSHES = 40_000
"""How long the schedule of section 5.2 rewards the start alone."""

_PAPER = {"start": K_START, "distance": K_DISTANCE, "inside": K_INSIDE, "success": K_SUCCESS}
_START = {"start": K_START, "inside": K_INSIDE}
_SEPARATION = {"distance": K_DISTANCE}

REWARDS: dict[str, RewardFunction] = {
    reward.name: reward
    for reward in (
        RewardFunction("paper", _PAPER),  # Eq. 7
        RewardFunction("separation", _SEPARATION),  # the baseline of section 5
        RewardFunction("start", _START),  # Fig. 6
        RewardFunction(  # Fig. 4, "pretrained"
            "start_then_separation", _SEPARATION, NUM_PRETRAINING_PUSHES, _START
        ),
    )
}
"""Every reward function by its name; a new one is one line here."""


def make_reward(name: str) -> RewardFunction:
    """Find a reward function by its name.

    Args:
        name: ``paper`` (Eq. 7), ``separation`` (r_Dist alone), ``start`` (r_Start and r_Inside) or
            ``start_then_separation`` (``start`` for 40,000 pushes, then ``separation``; section
            5.2). All use the weights of Eq. 7.

    Returns:
        The reward function.

    Raises:
        InvalidValueError: If there is none of this name.
    """
    if not isinstance(name, str) or name not in REWARDS:
        raise InvalidValueError("reward", name, ", ".join(REWARDS))
    return REWARDS[name]
