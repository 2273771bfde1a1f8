"""Environments of others that push objects and show pictures of them."""

import importlib
import importlib.util
import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from typing import Any

import gymnasium

from singulate.bench.turns import Stint, Turn

_EXTRA = "pip install -c constraints.txt -e '.[bench]'"


@dataclass(frozen=True)
class PeerSpec:
    """A peer, made as its own users make it.

    Attributes:
        package: Name of its distribution.
        module: What registers it.
        env_id: Its name at Gymnasium.
        settings: Further arguments of `gymnasium.make`, as pairs.
        renders: Whether the picture is not in the observation but has to be rendered.
        what: What one step is.
        install: How to get it.
    """

    package: str
    module: str
    env_id: str
    settings: tuple[tuple[str, object], ...]
    renders: bool
    what: str
    install: str = _EXTRA

    @property
    def is_installed(self) -> bool:
        """Whether it can be measured here."""
        return importlib.util.find_spec(self.module) is not None

    @property
    def note(self) -> str:
        """What is measured, of which version."""
        return f"{self.package} {version(self.package)}: {self.what}"

    @property
    def tool(self) -> Callable[[], "Peer"]:
        """A picklable factory."""
        return partial(Peer, self)


_PANDA = partial(PeerSpec, "panda-gym", "panda_gym", "PandaPush-v3", renders=True)
_PANDA_STEP = "a step of 40 ms and a picture by Bullet's software renderer"
_SMALL = (("render_mode", "rgb_array"), ("render_width", 64), ("render_height", 64))

PEERS: dict[str, PeerSpec] = {
    "PandaPush": _PANDA(
        settings=(("render_mode", "rgb_array"),),
        what=f"{_PANDA_STEP}, 720 x 480 as it comes",
    ),
    "PandaPush, small": _PANDA(settings=_SMALL, what=f"{_PANDA_STEP}, 64 x 64"),
    "PushT": PeerSpec(
        "gym-pusht",
        "gym_pusht",
        "gym_pusht/PushT-v0",
        (("obs_type", "pixels"), ("render_mode", "rgb_array")),
        renders=False,
        what="a step of 100 ms in two dimensions with its 96 x 96 pixels",
        install=f"{_EXTRA}, then pip install -c constraints.txt --no-deps gym-pusht",
    ),
}
"""By the name of their rows."""


class Peer:
    """A worker's tool: one environment.

    Args:
        spec: Which.
    """

    def __init__(self, spec: PeerSpec) -> None:
        # Bullet greets on standard output, where `singulate bench --json` prints its numbers.
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        importlib.import_module(spec.module)
        settings: dict[str, Any] = dict(spec.settings)
        self._env: gymnasium.Env[Any, Any] = gymnasium.make(
            spec.env_id, disable_env_checker=True, **settings
        )
        self._renders = spec.renders
        self.seconds_a_step = 1.0 / float(self._env.unwrapped.metadata["render_fps"])

    def run(self, turn: Turn) -> Stint:
        """Uniformly random actions; a new episode wherever one ends."""
        self._env.reset(seed=turn.seed)
        self._env.action_space.seed(turn.seed)
        num_steps = 0
        began = time.perf_counter()
        while not num_steps or time.perf_counter() - began < turn.seconds:
            *_, terminated, truncated, _ = self._env.step(self._env.action_space.sample())
            if self._renders:
                self._env.render()
            if terminated or truncated:
                self._env.reset()
            num_steps += 1
        spent = time.perf_counter() - began
        return Stint(num_steps, spent, spent, num_steps * self.seconds_a_step)

    def close(self) -> None:
        """Release the environment."""
        self._env.close()


def run_peer(peer: Peer, turn: Turn) -> Stint:
    """Work for an engine: one turn of a peer."""
    return peer.run(turn)
