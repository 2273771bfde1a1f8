"""JSON objects that come from a file somebody may have damaged."""

import json
from typing import Any


def parse_json_object(data: bytes | str) -> dict[str, Any]:
    """Read one JSON object.

    Raises:
        ValueError: If it is not valid JSON or not an object.
    """
    try:
        content = json.loads(data)
    except RecursionError:
        raise ValueError("nested too deeply") from None
    if not isinstance(content, dict):
        raise ValueError("not a JSON object")
    return content
