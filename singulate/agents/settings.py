"""What can be set of an agent, for people to look up."""

import inspect
import re
from dataclasses import fields
from typing import Any, NamedTuple

from singulate.agents.registry import agent_kind

_ATTRIBUTE = re.compile(r"^    (\w+): (.+(?:\n {5,}.+)*)", re.MULTILINE)


class Setting(NamedTuple):
    """One setting of an agent.

    Attributes:
        name: As in ``--set NAME=VALUE``.
        default: Its value where nothing else is said.
        meaning: From the docstring of the agent's configuration.
    """

    name: str
    default: Any
    meaning: str


def settings_of(agent: str) -> list[Setting]:
    """All settings of a kind of agent.

    Raises:
        InvalidValueError: If there is no such agent.
    """
    config_class = agent_kind(agent).config_class
    meanings: dict[str, str] = {}
    for each in reversed(config_class.__mro__):
        text = inspect.cleandoc(each.__doc__ or "")
        meanings |= {name: " ".join(said.split()) for name, said in _ATTRIBUTE.findall(text)}
    return [Setting(each.name, each.default, meanings[each.name]) for each in fields(config_class)]
