"""Small scripts of our own that run in a browser beside viser's."""

from importlib import resources
from string import Template

import viser
from viser import _messages


def run_script(client: viser.ClientHandle, name: str, **values: str) -> None:
    """Run one of our scripts in a browser.

    Args:
        client: The browser.
        name: A file among our assets.
        values: What stands for each ``$name`` in it.
    """
    template = Template(resources.files("app").joinpath("assets", name).read_text())
    source = template.substitute(values)
    client._websock_connection.queue_message(_messages.RunJavascriptMessage(source))
