"""What a page at rest costs: bytes, processor time and memory, from one client to many."""

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from time import monotonic

import psutil

from singulate.bench.dashboard_process import RunningDashboard, running_dashboard
from singulate.bench.dashboard_socket import DashboardSocket, open_socket
from singulate.bench.measurement import Measurement

NUM_CLIENTS = (1, 5, 20)
_CALM_BYTES = 2000
"""A page that is sent less than this in `_CALM_S` has got all that it shows."""
_CALM_S = 2.0
_PLACE = (-0.8, -0.7)


def bench_clients(directory: Path, seconds: float) -> Iterator[Measurement]:
    """Let more and more pages that draw nothing look at one table, at rest and during pushes."""
    with running_dashboard(directory) as dashboard, ExitStack() as stack:
        sockets: list[DashboardSocket] = []
        for num_clients in NUM_CLIENTS:
            while len(sockets) < num_clients:
                sockets.append(stack.enter_context(open_socket(dashboard.url)))
            for socket in sockets:
                socket.wait_until_calm(_CALM_S, _CALM_BYTES)
            yield from _costs(dashboard, sockets, seconds)
        yield from _memory(dashboard)


def _costs(
    dashboard: RunningDashboard, sockets: list[DashboardSocket], seconds: float
) -> Iterator[Measurement]:
    with ServerTime(dashboard.pid) as idle:
        idle_bytes = sockets[0].num_bytes(seconds)
    delays: list[float] = []
    with ServerTime(dashboard.pid) as busy:
        while busy.elapsed < seconds:
            delays.append(sockets[0].click(*_PLACE))
    for socket in sockets:
        socket.wait_until_calm(_CALM_S, _CALM_BYTES)
    slowest = f"slowest of {len(delays)}, nothing is drawn"
    for name, value, unit, note in (
        ("bytes to an idle client", idle_bytes / seconds, "B/s", "all fields there, no training"),
        ("processor share of the server at rest", idle.share, "cores", "the page's own process"),
        ("processor share while pushing", busy.share, "cores", "one push after the other"),
        ("click to motion with clients", 1e3 * max(delays), "ms", slowest),
    ):
        yield Measurement(name, value, unit, note, axis="clients", at=len(sockets))


class ServerTime:
    """Processor time of a process during a block.

    Args:
        pid: The process.

    Attributes:
        share: Cores that it kept busy.
    """

    def __init__(self, pid: int) -> None:
        self._process = psutil.Process(pid)
        self.share = 0.0

    @property
    def elapsed(self) -> float:
        """Time since the block began [s]."""
        return monotonic() - self._began_at

    def __enter__(self) -> "ServerTime":
        self._began_at, self._used = monotonic(), self._seconds()
        return self

    def __exit__(self, *_: object) -> None:
        self.share = (self._seconds() - self._used) / self.elapsed

    def _seconds(self) -> float:
        times = self._process.cpu_times()
        return float(times.user + times.system)


def _memory(dashboard: RunningDashboard) -> Iterator[Measurement]:
    server = psutil.Process(dashboard.pid)
    peaks = {"server": _peak_mib(server)}
    for child in server.children(recursive=True):
        name = _name(child)
        if name:
            peaks[name] = max(peaks.get(name, 0.0), _peak_mib(child))
    for name, peak in peaks.items():
        yield Measurement(f"peak memory, {name}", peak, "MiB", f"after {NUM_CLIENTS[-1]} clients")


def _name(process: psutil.Process) -> str:
    command = " ".join(process.cmdline())
    if "singulate.engine.worker" in command:
        return "reward-map worker"
    if "spawn_main" not in command:
        return ""
    libraries = Path(f"/proc/{process.pid}/maps").read_text(errors="replace")
    if "libtorch" in libraries:
        return "policy"
    return "scene" if "pybullet" in libraries else "reward map"


def _peak_mib(process: psutil.Process) -> float:
    status = Path(f"/proc/{process.pid}/status").read_text()
    line = next(line for line in status.splitlines() if line.startswith("VmHWM"))
    return int(line.split()[1]) / 1024
