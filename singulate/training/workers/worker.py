"""The life of a worker: ``python -m singulate.training.workers.worker FD PARENT_PID``."""

import signal
import sys
from contextlib import suppress
from multiprocessing.connection import Connection

from singulate.engine.parent_death import die_with_parent
from singulate.training.workers.env_server import EnvServer
from singulate.training.workers.messages import Answer, Failed, Request


def main(fd: int, parent_pid: int) -> None:
    """Serve pushes from the inherited socket `fd` until the parent is gone.

    The trainer alone acts on signals that ask the whole group of processes to stop.
    """
    die_with_parent(parent_pid)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    connection = Connection(fd)
    with suppress(EOFError, BrokenPipeError, ConnectionResetError):
        server = EnvServer(connection.recv())
        while True:
            answer = _answer(server, connection.recv())
            connection.send(answer)
            if isinstance(answer, Failed):
                return


def _answer(server: EnvServer, request: Request) -> Answer:
    try:
        return server.answer(request)
    except Exception as error:  # the trainer reports it; a retry would only repeat it
        return Failed(f"{type(error).__name__}: {error}".replace("\n", " "))


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:3]))
