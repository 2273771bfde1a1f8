"""``python -m app``: start the dashboard and print where it is."""

import shlex
import signal
import sys
import threading
import warnings
import webbrowser
from collections.abc import Sequence
from pathlib import Path

from app.first_look import FirstLook
from app.laboratory import Laboratory
from app.loop import Dashboard
from app.opening import prepare_opening
from app.options import Options, parse_options
from app.security import AccessPolicy
from app.server import bind, open_server
from singulate.exceptions import SingulateError
from singulate.geometry import Workspace


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the dashboard until it is interrupted.

    Returns:
        Exit status: 0 after an interruption, 2 with one line of explanation for bad options.
    """
    try:
        serve(parse_options(arguments))
    except SingulateError as error:
        print(f"singulate: error: {error}", file=sys.stderr)
        return 2
    return 0


def serve(options: Options) -> None:
    """Open the door, start the laboratory, and draw until the process is asked to stop.

    A trainer that was started from the page saves a checkpoint and stops too; if this process is
    killed instead, it goes on, and the next dashboard finds it.

    Raises:
        SingulateError: If an option is not allowed, or the port is taken.
    """
    listener = bind(options.host, options.port)
    port: int = listener.getsockname()[1]
    policy = AccessPolicy(options.host, port, options.token)
    laboratory = Laboratory(scenario=options.scenario, seed=options.seed, run_dir=options.run)
    stop = threading.Event()
    # A browser that leaves while its page is drawn is no news.
    warnings.filterwarnings("ignore", message="Queued a .* on a closed connection")
    try:
        workspace = Workspace()
        first_look = FirstLook(workspace)
        server = open_server(listener, policy, laboratory.wake, first_look.dress)
        dashboard = Dashboard(server, laboratory, workspace, on_snapshot=first_look.show)
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda *_: stop.set())
        prepare_opening(laboratory, workspace, stop)
        print(f"singulate: open {policy.url}", flush=True)
        if options.opens_browser:
            webbrowser.open(policy.url)
        dashboard.run(stop)
        server.stop()
    finally:
        tell_stopped(laboratory.close())


def tell_stopped(run_dir: Path | None) -> None:
    """Say on standard error which run was stopped with the dashboard, and how to continue it."""
    if run_dir is not None:
        command = f"singulate train --resume {shlex.quote(str(run_dir))}"
        text = f"training of {run_dir.name} was stopped; continue with: {command}"
        print(f"singulate: {text}", file=sys.stderr)


if __name__ == "__main__":
    sys.exit(main())
