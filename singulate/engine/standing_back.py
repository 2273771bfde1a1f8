"""How a process stands back behind others, also behind those of other sessions."""

import os
import time
from contextlib import suppress
from pathlib import Path

_ATTEMPTS = 20
_PAUSE_S = 0.11
"""Linux takes ten such requests a second from all ordinary users together."""


def stand_back(niceness: int) -> None:
    """Add to this process's niceness; to be called before it starts any other.

    Linux may share a core between sessions first and heed niceness only among the processes of
    one ("autogroup", sched(7)): a worker of the dashboard then takes as much as a whole browser,
    whatever its niceness. One that stands back therefore gets a session of its own, which as a
    whole is as nice as the process.

    Args:
        niceness: Zero leaves everything as it is.
    """
    if niceness == 0:
        return
    with suppress(PermissionError):  # it leads a group or a session already
        os.setsid()
    set_back(os.getpid(), os.nice(0) + niceness)


def set_back(pid: int, niceness: int) -> None:
    """Make a process this nice, and its session too, where it leads one and Linux lets it.

    Args:
        pid: The process.
        niceness: Its new niceness; above 19 counts as 19.

    Raises:
        OSError: If there is no such process, or it may not be made so.
    """
    niceness = min(niceness, 19)
    os.setpriority(os.PRIO_PROCESS, pid, niceness)
    session = Path(f"/proc/{pid}/autogroup")
    if os.getsid(pid) != pid or not session.exists():
        return
    for _ in range(_ATTEMPTS):
        try:
            session.write_text(str(niceness))
            return
        except BlockingIOError:
            time.sleep(_PAUSE_S)
        except OSError:
            return
