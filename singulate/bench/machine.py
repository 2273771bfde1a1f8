"""On what the numbers were measured."""

import os
import platform
from importlib.metadata import version
from pathlib import Path

_PACKAGES = ("pybullet", "numpy", "torch", "viser")


def describe_machine() -> dict[str, str | int | float]:
    """Processor, cores, load before the benchmark, and versions."""
    return {
        "processor": _processor(),
        "num_cores": os.cpu_count() or 1,
        "load_average": round(os.getloadavg()[0], 2),
        "python": platform.python_version(),
        **{package: version(package) for package in _PACKAGES},
    }


def _processor() -> str:
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()
