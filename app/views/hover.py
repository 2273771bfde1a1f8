"""The aim arrow follows the pointer without asking the server."""

from importlib import resources
from string import Template

import viser
from viser import _messages


def follow_pointer(client: viser.ClientHandle, node: str, reach: float, height: float) -> None:
    """Let a node follow the pointer over the table in one browser.

    Args:
        client: The browser.
        node: Name of the node.
        reach: Half the side of the square in which it follows [m].
        height: How far above the table it is kept [m].
    """
    template = Template(resources.files("app").joinpath("assets/hover.js").read_text())
    source = template.substitute(node=node, reach=f"{reach:.6f}", height=f"{height:.6f}")
    client._websock_connection.queue_message(_messages.RunJavascriptMessage(source))
