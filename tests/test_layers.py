"""Imports only go downward, and each heavy library enters through one door."""

import ast
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent

LAYERS: tuple[tuple[str, ...], ...] = (
    ("exceptions", "finite"),
    ("geometry", "outcomes", "paths", "registration"),
    ("simulation", "perception"),
    ("rewards",),
    ("envs", "checkpoints", "runs"),
    ("engine",),
    ("agents",),
    ("rewardmap",),
    ("datasets",),
    ("evaluation", "training"),
    ("experiments", "bench"),
    ("singulate",),  # the package's own front door, which loads policies on demand
    ("cli",),
    ("__main__",),
    ("app",),
)
"""From the ground up; units of one layer are peers and may not import each other."""

RANK = {unit: rank for rank, layer in enumerate(LAYERS) for unit in layer}

DOWNWARD_AMONG_PEERS = {("runs", "checkpoints")}
"""A run directory holds checkpoints; a checkpoint knows of no run."""


def from_layer_up(unit: str) -> frozenset[str]:
    """Units that may load a heavy library; never the front door, which everybody passes."""
    return frozenset(other for other in RANK if RANK[other] >= RANK[unit]) - {"singulate"}


ALLOWED_IN: dict[str, frozenset[str]] = {
    "pybullet": frozenset({"simulation"}),
    "pybullet_data": frozenset({"simulation"}),
    "viser": frozenset({"app"}),
    "ray": frozenset({"engine"}),
    "torch": from_layer_up("agents"),
    "safetensors.torch": from_layer_up("agents"),
    "stable_baselines3": from_layer_up("agents"),
    "sb3_contrib": from_layer_up("agents"),
    "cv2": from_layer_up("perception"),
}
HEAVY = {"torch", "stable_baselines3", "sb3_contrib", "cv2", "pybullet", "viser", "ray"}


def unit_of(module: str) -> str:
    """``singulate.runs.lock`` belongs to ``runs``, ``app.server`` to ``app``."""
    top, *rest = module.split(".")
    return rest[0] if top == "singulate" and rest else top


def imported_modules(module: str, source: str, is_package: bool = False) -> Iterator[str]:
    """Absolute names that a module imports anywhere, also inside functions."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                parts = module.split(".")
                parents = parts[: len(parts) - node.level + is_package]
                base = ".".join([*parents, *filter(None, [node.module])])
            names = [alias.name for alias in node.names]
            if base == "singulate":
                yield from (f"{base}.{name}" if name in RANK else base for name in names)
            elif base == "safetensors":
                yield from (f"{base}.{name}" for name in names)
            else:
                yield base


def is_violation(module: str, imported: str) -> bool:
    unit = unit_of(module)
    for library, units in ALLOWED_IN.items():
        if imported == library or imported.startswith(library + "."):
            return unit not in units
    target = unit_of(imported)
    is_ours = imported.split(".")[0] in ("singulate", "app")
    if not is_ours or target == unit or (unit, target) in DOWNWARD_AMONG_PEERS:
        return False
    return unit != "singulate" and RANK[target] >= RANK[unit]


def violations(module: str, source: str, is_package: bool = False) -> list[str]:
    imports = imported_modules(module, source, is_package)
    return [f"{module} -> {imported}" for imported in imports if is_violation(module, imported)]


def all_modules() -> Iterator[tuple[str, Path]]:
    for package in ("singulate", "app"):
        for path in sorted((ROOT / package).rglob("*.py")):
            parts = path.relative_to(ROOT).with_suffix("").parts
            yield ".".join(parts[:-1] if parts[-1] == "__init__" else parts), path


def test_every_module_belongs_to_a_layer() -> None:
    assert sorted({unit_of(module) for module, _ in all_modules()} - set(RANK)) == []


def test_imports_only_go_downward() -> None:
    found = [
        violation
        for module, path in all_modules()
        for violation in violations(module, path.read_text("utf-8"), path.name == "__init__.py")
    ]
    assert found == []


def test_the_checker_sees_the_imports_that_are_there() -> None:
    seen = {
        (unit_of(module), imported.split(".")[0])
        for module, path in all_modules()
        for imported in imported_modules(module, path.read_text("utf-8"))
    }
    doors = {("simulation", "pybullet"), ("perception", "cv2"), ("agents", "torch")}
    assert seen >= doors | {("app", "viser"), ("rewards", "singulate")}


@pytest.mark.parametrize(
    ("module", "source", "imported"),
    [
        ("singulate.geometry.push", "import singulate.rewards", "singulate.rewards"),
        ("singulate.rewards.start", "from singulate.envs import X", "singulate.envs"),
        ("singulate.rewards.start", "from singulate import envs", "singulate.envs"),
        ("singulate.rewards.start", "from ..envs.config import X", "singulate.envs.config"),
        ("singulate.rewards.start", "def f():\n from singulate import cli", "singulate.cli"),
        ("singulate.perception.x", "import singulate.simulation", "singulate.simulation"),
        ("singulate.simulation.x", "from singulate.perception import X", "singulate.perception"),
        ("singulate.runs.x", "import singulate.envs", "singulate.envs"),
        ("singulate.envs.x", "import singulate.runs", "singulate.runs"),
        ("singulate.checkpoints.x", "import singulate.runs", "singulate.runs"),
        ("singulate.agents.x", "from singulate import load_policy", "singulate"),
        ("singulate.cli.app", "from app.server import main", "app.server"),
        ("singulate.envs.x", "import pybullet as p", "pybullet"),
        ("singulate.cli.x", "import viser", "viser"),
        ("singulate.engine.x", "import torch.nn as nn", "torch.nn"),
        ("singulate.experiments.x", "import ray", "ray"),
        ("singulate.checkpoints.x", "from safetensors import torch", "safetensors.torch"),
        ("singulate.runs.x", "from stable_baselines3.dqn import X", "stable_baselines3.dqn"),
        ("singulate.geometry.x", "import cv2", "cv2"),
        ("singulate", "import cv2", "cv2"),
        ("singulate", "import torch", "torch"),
        ("singulate", "from singulate.agents.loading import load_policy", None),
        ("singulate.cli.train", "from singulate import load_policy", None),
        ("singulate.runs.x", "from singulate.geometry import Push", None),
        ("singulate.runs.x", "from .lock import RunLock", None),
        ("singulate.runs.x", "import singulate.checkpoints", None),
        ("singulate.training.x", "import torch, numpy", None),
        ("singulate.simulation.scene", "import pybullet", None),
        ("singulate.checkpoints.x", "import safetensors.numpy", None),
        ("app.views.table", "import viser\nfrom singulate.rewardmap import X", None),
        ("app.panels.x", "from app.views import X\nimport application", None),
    ],
)
def test_the_checker_on_hand_made_modules(module: str, source: str, imported: str | None) -> None:
    assert violations(module, source) == ([] if imported is None else [f"{module} -> {imported}"])


def test_relative_imports_of_a_package_start_at_itself() -> None:
    assert list(imported_modules("singulate.runs", "from .lock import X", True)) == [
        "singulate.runs.lock"
    ]


def loaded_by(statement: str) -> set[str]:
    """Names of the top-level modules that a fresh interpreter has loaded after a statement."""
    code = f"{statement}\nimport sys\nprint(*{{name.split('.')[0] for name in sys.modules}})"
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=120
    )
    assert result.returncode == 0, result.stderr
    return set(result.stdout.split())


def test_importing_singulate_loads_nothing_heavy() -> None:
    loaded = loaded_by("import singulate")
    assert "singulate" in loaded
    assert loaded & HEAVY == set()


def test_environments_and_records_work_without_torch() -> None:
    units = ("envs.push_env", "checkpoints", "runs", "engine")
    loaded = loaded_by("import " + ", ".join(f"singulate.{unit}" for unit in units))
    assert loaded & HEAVY == {"cv2", "pybullet"}
