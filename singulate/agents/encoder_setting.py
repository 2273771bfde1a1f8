"""The setting that gives an agent a code of the distance map instead of the map."""

from collections.abc import Mapping
from typing import Any

from singulate.exceptions import InvalidValueError


def check_encoder(value: object) -> None:
    """Check the setting alone; whether such an autoencoder is there, a new training looks up.

    Raises:
        InvalidValueError: Unless `value` is a text or None.
    """
    if value is not None and (not isinstance(value, str) or not value):
        raise InvalidValueError("encoder", value, "the directory of an autoencoder, or null")


def check_encoder_fits(agent_config: Mapping[str, Any], observation: str) -> None:
    """Check that an agent with an encoder gets what the encoder was made for.

    Raises:
        InvalidValueError: If it is to code anything but a distance map.
    """
    encoder = agent_config.get("encoder")
    if encoder is not None and observation != "distance_map":
        raise InvalidValueError("encoder", encoder, f"nothing beside observation {observation}")
