"""What a scene can be made from."""

from singulate.exceptions import InvalidValueError
from singulate.simulation import make_scenario

MAX_SEED = 2**63 - 1


def check_recipe(scenario: object, seed: object) -> None:
    """Check a scenario and a seed that came from outside.

    Raises:
        InvalidValueError: If there is no such scenario, or the seed is out of range.
    """
    if not isinstance(scenario, str):
        raise InvalidValueError("scenario", scenario, "a name such as random-2")
    make_scenario(scenario)
    if isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed <= MAX_SEED:
        raise InvalidValueError("seed", seed, "an integer from 0 to 2**63 - 1")
