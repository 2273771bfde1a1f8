"""The pipe between a child process and its parent."""

import select
from multiprocessing.connection import Connection

Pipe = Connection
"""Either end of a two-way pipe."""


def has_room(pipe: Pipe) -> bool:
    """Whether a message of up to some 100 kB can be written without waiting."""
    poll = select.poll()
    try:
        poll.register(pipe.fileno(), select.POLLOUT)
        return any(events & select.POLLOUT for _, events in poll.poll(0))
    except (OSError, ValueError):
        return False
