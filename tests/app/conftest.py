"""A laboratory with real processes, ticked by the tests; scripted pictures of one for its page."""

import time
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
import viser

from app.commands import Command
from app.laboratory import Laboratory
from app.panels.context import PanelContext
from app.panels.secondary import SecondaryButtons
from app.preferences import Preferences
from app.snapshot import (
    Curve,
    PolicySnapshot,
    PushReport,
    RewardMapSnapshot,
    RunSnapshot,
    SceneSnapshot,
    Snapshot,
)
from singulate.agents.loading import tensors_of
from singulate.agents.registry import agent_kind
from singulate.checkpoints import Manifest, save_checkpoint
from singulate.envs import EnvConfig
from singulate.geometry import Direction, Push


class Bench:
    """Ticks a laboratory until something is so."""

    def __init__(self, laboratory: Laboratory) -> None:
        self.laboratory = laboratory
        self.snapshot = laboratory.tick()

    def tick(self):
        self.laboratory.wait(0.01)
        self.snapshot = self.laboratory.tick()
        return self.snapshot

    def until(self, condition, timeout_s=60.0):
        deadline = time.monotonic() + timeout_s
        while time.monotonic() < deadline:
            if condition(self.tick()):
                return self.snapshot
        raise AssertionError(f"waited in vain; notices: {self.texts}")

    def run(self, duration_s):
        end = time.monotonic() + duration_s
        snapshots = []
        while time.monotonic() < end:
            snapshots.append(self.tick())
        return snapshots

    def do(self, *commands):
        for command in commands:
            self.laboratory.submit(command)

    @property
    def texts(self):
        return [notice.text for notice in self.snapshot.notices]


@pytest.fixture(scope="module")
def make_bench(tmp_path_factory):
    benches = []

    def make(**options):
        directory = tmp_path_factory.mktemp("laboratory")
        options = {
            "runs_dir": directory / "runs",
            "checkpoints_dir": directory / "checkpoints",
            "num_workers": 1,
            **options,
        }
        benches.append(Bench(Laboratory(**options)))
        benches[-1].until(lambda s: s.scene is not None)
        return benches[-1]

    yield make
    for bench in benches:
        bench.laboratory.close()


@pytest.fixture(scope="session")
def untrained(tmp_path_factory):
    """Untrained checkpoints of some agents, saved as a trainer saves them."""
    directory = tmp_path_factory.mktemp("checkpoints")
    for agent, action in (("dqn", "grid"), ("ppo", "point"), ("spatial", "point")):
        env = EnvConfig(scenario="random-2", action=action)
        kind = agent_kind(agent)
        _, network = kind.build_policy(kind.make_config({}), env)
        manifest = Manifest(agent=agent, agent_config={}, env_config=env.to_dict(), step=1234)
        save_checkpoint(directory / f"{agent}-untrained", tensors_of(network), manifest, {})
    return directory


@pytest.fixture
def make_report() -> Callable[..., PushReport]:
    labels = np.zeros((64, 64), np.int32)
    labels[30:36, 26:38] = 1
    apart = labels.copy()
    apart[30:36, 32:38] = 2

    def make(**changes: Any) -> PushReport:
        values: dict[str, Any] = {
            "push": Push.cardinal((0.25, -0.5), Direction.RIGHT, 0.5),
            "by": "you",
            "predicted": 800.0,
            "reward": 1264.0,
            "weighted_terms": {"start": 214.0, "distance": 50.0, "inside": 0.0, "success": 1000.0},
            "is_success": True,
            "outcome": "success",
            "num_segments": (1, 2),
            "label_images": (labels, apart),
        }
        return PushReport(**{**values, **changes})

    return make


@pytest.fixture
def make_scene() -> Callable[..., SceneSnapshot]:
    distances = np.full((64, 64), 5.0, np.float32)
    distances[30:36, 26:38] = -1.0
    values: dict[str, Any] = {
        "version": 3,
        "scenario": "random-2",
        "seed": 7,
        "num_blocks": 2,
        "poses": (),
        "pusher": None,
        "is_pushing": False,
        "is_paused": False,
        "speed": 1.0,
        "is_watching": False,
        "can_undo": True,
        "active_push": None,
        "pushed_by": "",
        "distance_map": distances,
        "mask": distances < 0.0,
        "rgb": np.full((64, 64, 3), 120, np.uint8),
        "num_segments": 1,
        "is_success": False,
        "motion_count": 0,
        "last_push": None,
    }
    return lambda **changes: SceneSnapshot(**{**values, **changes})


@pytest.fixture
def make_run() -> Callable[..., RunSnapshot]:
    steps = np.arange(0.0, 1000.0, 10.0)
    starts = np.zeros((1000, 2), np.float32)
    starts[:500] = (0.5, 0.5)
    values: dict[str, Any] = {
        "run_dir": "/runs/dqn-a",
        "name": "dqn-a",
        "agent": "dqn",
        "scenario": "random-2",
        "state": "running",
        "reason": "",
        "num_steps": 1000,
        "total_steps": 4000,
        "pushes_per_second": 200.0,
        "eta_s": 15.0,
        "age_s": 0.5,
        "curves": {"rollout/ep_rew_mean": Curve(steps, steps * 0.5)},
        "starts": starts,
        "start_steps": np.arange(1, 1001, dtype=np.int64),
        "last_checkpoint": "",
        "revision": 1,
    }
    return lambda **changes: RunSnapshot(**{**values, **changes})


@pytest.fixture
def make_snapshot(
    make_scene: Callable[..., SceneSnapshot], make_run: Callable[..., RunSnapshot]
) -> Callable[..., Snapshot]:
    rewards = np.zeros((4, 32, 32), np.float32)
    rewards[Direction.RIGHT, 8, 4] = 1300.0
    rewards[:, 15:18, 13:19] = -100.0
    q_map = np.zeros((4, 10, 10), np.float32)
    q_map[Direction.RIGHT, 2, 1] = 900.0
    density = np.full((64, 64), 1.0 / 4096.0, np.float32)
    values: dict[str, Any] = {
        "scene": make_scene(),
        "reward_map": RewardMapSnapshot(rewards, 32, 0.25, 3),
        "policy": PolicySnapshot(
            "dqn-a", "dqn", "checkpoints/dqn-a", 20000, True, q_map, density, ((9, 5),), 3, False
        ),
        "run": make_run(),
        "policies": (("dqn-a", "checkpoints/dqn-a"), ("ppo-b", "checkpoints/ppo-b")),
        "runs": ("/runs/dqn-a", "/runs/ppo-b"),
        "notices": (),
    }
    return lambda **changes: Snapshot(**{**values, **changes})


@pytest.fixture
def submitted() -> list[Command]:
    return []


@pytest.fixture
def reports() -> list[str]:
    return []


@pytest.fixture
def context(submitted: list[Command], reports: list[str]) -> Iterator[PanelContext]:
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    yield PanelContext(
        server.gui,
        submitted.append,
        Preferences(),
        reports.append,
        SecondaryButtons(server.gui, is_dark=False),
    )
    server.stop()
