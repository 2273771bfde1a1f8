"""How much memory processes hold and have held."""

import os
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

from singulate.engine import Engine

_TASK_S = 0.05
"""An idle worker takes its task sooner than a busy one ends this long a task."""


class Memory(NamedTuple):
    """Resident memory of one process.

    Attributes:
        pid: Which process.
        resident_bytes: What it holds now.
        peak_bytes: The most that it has held.
    """

    pid: int
    resident_bytes: int
    peak_bytes: int


def own_memory() -> Memory:
    """Of this process; on Linux the peak is this program's alone, without its parent's."""
    return memory_of(os.getpid())


def memory_of(pid: int) -> Memory:
    """Of any process of ours; where there is no /proc, the peak of another one is what it holds."""
    status = Path(f"/proc/{pid}/status")
    if status.exists():
        lines = (line.partition(":") for line in status.read_text().splitlines())
        fields = {key: value for key, _, value in lines}
        resident, peak = (1024 * int(fields[key].split()[0]) for key in ("VmRSS", "VmHWM"))
        return Memory(pid, resident, peak)
    ps = ("ps", "-o", "rss=", "-p", str(pid))
    resident = 1024 * int(subprocess.run(ps, capture_output=True, check=True).stdout)
    if pid != os.getpid():
        return Memory(pid, resident, resident)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return Memory(pid, resident, peak * (1 if sys.platform == "darwin" else 1024))


def workers_memory(engine: Engine) -> list[Memory]:
    """Of every worker of an idle engine, in the order of their process ids."""
    seconds = _TASK_S if engine.num_workers > 1 else 0.0
    batch = engine.submit(_report, [seconds] * engine.num_workers, int)
    return sorted({memory.pid: memory for memory in (each.value for each in batch)}.values())


def workers_peak_mib(engine: Engine) -> float:
    """The most that any worker of an idle engine has held [MiB]."""
    return max(memory.peak_bytes for memory in workers_memory(engine)) / 2**20


def _report(_tool: int, seconds: float) -> Memory:
    time.sleep(seconds)
    return own_memory()
