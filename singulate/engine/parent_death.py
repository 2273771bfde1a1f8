"""A child process ends when its parent does, however the parent ended."""

import ctypes
import os
import signal
import sys

_PR_SET_PDEATHSIG = 1


def die_with_parent(parent_pid: int) -> None:
    """Ask the kernel to kill this process when its parent ends; Linux only, else nothing.

    Elsewhere a child notices the end of its pipe (`EOFError`) the next time that it looks. The
    kernel ties the signal to the *thread* that started the child, so children are started from a
    thread that lives as long as the program.

    Args:
        parent_pid: Process that started this one; if it is already gone, this process exits.
    """
    if sys.platform != "linux":
        return
    ctypes.CDLL(None, use_errno=True).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent_pid:
        os._exit(1)
