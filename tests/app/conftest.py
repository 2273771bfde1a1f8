"""A laboratory with real processes, ticked by the tests."""

import time

import pytest

from app.laboratory import Laboratory
from singulate.agents.loading import tensors_of
from singulate.agents.registry import agent_kind
from singulate.checkpoints import Manifest, save_checkpoint
from singulate.envs import EnvConfig


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
    """Untrained checkpoints of both agents, saved as a trainer saves them."""
    directory = tmp_path_factory.mktemp("checkpoints")
    for agent, action in (("dqn", "grid"), ("ppo", "point")):
        env = EnvConfig(scenario="random-2", action=action)
        kind = agent_kind(agent)
        _, network = kind.build_policy(kind.make_config({}), env)
        manifest = Manifest(agent=agent, agent_config={}, env_config=env.to_dict(), step=1234)
        save_checkpoint(directory / f"{agent}-untrained", tensors_of(network), manifest, {})
    return directory
