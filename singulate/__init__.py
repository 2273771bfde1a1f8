"""A laboratory for one robot skill: telling objects apart by pushing them.

Importing this package registers ``singulate/Push-v0`` with Gymnasium:

    >>> import gymnasium, singulate
    >>> env = gymnasium.make("singulate/Push-v0", scenario="random-2")
    >>> observation, info = env.reset(seed=0)
    >>> observation.shape, info["num_segments"]
    ((64, 64), 1)
"""

from typing import TYPE_CHECKING, Any

from singulate.registration import register_environments

if TYPE_CHECKING:
    from singulate.agents.loading import load_policy

__all__ = ["load_policy"]

register_environments()


def __getattr__(name: str) -> Any:
    """Import what needs torch only when somebody asks for it."""
    if name == "load_policy":
        from singulate.agents.loading import load_policy

        return load_policy
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
