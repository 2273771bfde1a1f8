"""What the dashboard can be started with."""

import argparse
import secrets
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from app.choices import MAX_SEED
from app.scene_recipe import check_recipe
from app.security.access import is_loopback
from singulate.cli import OneLineParser
from singulate.exceptions import InvalidValueError

DEFAULT_PORT = 8080
MIN_TOKEN = 8


@dataclass(frozen=True)
class Options:
    """Checked options.

    Attributes:
        host: Address to listen on.
        port: Port; 0 for a free one.
        token: Secret that the page asks for; None for none.
        run: Run directory to watch.
        scenario: Scene to begin with.
        seed: Its seed.
        opens_browser: Whether to open a browser.
    """

    host: str = "127.0.0.1"
    port: int = DEFAULT_PORT
    token: str | None = None
    run: Path | None = None
    scenario: str = "random-2"
    seed: int = 0
    opens_browser: bool = False


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Describe the options; the command line of the package offers the same."""
    parser.add_argument("--host", default=Options.host, help="address to listen on (%(default)s)")
    parser.add_argument(
        "--port", type=int, default=Options.port, help="port, or 0 for a free one (%(default)s)"
    )
    parser.add_argument(
        "--token",
        metavar="TOKEN|auto",
        help="secret that the page asks for; needed for any --host that others can reach",
    )
    parser.add_argument("--run", type=Path, metavar="DIR", help="run directory to watch")
    parser.add_argument(
        "--scenario", default=Options.scenario, help="scene to begin with (%(default)s)"
    )
    parser.add_argument("--seed", type=int, default=Options.seed, help="its seed (%(default)s)")
    parser.add_argument("--open", action="store_true", help="open a browser")


def parse_options(arguments: Sequence[str] | None = None) -> Options:
    """Options from a command line; what cannot be parsed leaves with one line and status 2.

    Raises:
        InvalidValueError: If a value is not allowed.
    """
    parser = OneLineParser(prog="singulate app", description="The dashboard.")
    add_arguments(parser)
    return check_options(parser.parse_args(arguments))


def check_options(parsed: argparse.Namespace) -> Options:
    """Options from arguments that `add_arguments` described.

    Raises:
        InvalidValueError: If a value is not allowed, or others could reach the page without a
            token.
    """
    if not 0 <= parsed.port <= 65535:
        raise InvalidValueError("--port", parsed.port, "0 to 65535")
    if not 0 <= parsed.seed <= MAX_SEED:
        raise InvalidValueError("--seed", parsed.seed, f"0 to {MAX_SEED}")
    check_recipe(parsed.scenario, parsed.seed)
    if parsed.run is not None and not parsed.run.is_dir():
        raise InvalidValueError("--run", str(parsed.run), "an existing run directory")
    token = secrets.token_urlsafe(16) if parsed.token == "auto" else parsed.token
    if token is not None and (len(token) < MIN_TOKEN or not _is_url_safe(token)):
        raise InvalidValueError(
            "--token", token, f"auto, or at least {MIN_TOKEN} letters, digits, - and _"
        )
    if token is None and not is_loopback(parsed.host):
        raise InvalidValueError(
            "--host", parsed.host, "127.0.0.1, or any address together with --token auto"
        )
    return Options(
        parsed.host, parsed.port, token, parsed.run, parsed.scenario, parsed.seed, parsed.open
    )


def _is_url_safe(token: str) -> bool:
    return token.isascii() and all(letter.isalnum() or letter in "-_" for letter in token)
