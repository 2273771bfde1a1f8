"""A writer is killed at random moments; what it finished before is still there."""

import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

from singulate.checkpoints import (
    Manifest,
    checkpoint_name,
    latest_checkpoint,
    read_checkpoint,
    save_checkpoint,
)

WRITER = """
import sys
from pathlib import Path
import numpy as np
from singulate.checkpoints import Manifest, checkpoint_name, save_checkpoint
parent, step = Path(sys.argv[1]), int(sys.argv[2])
while True:
    step += 1
    tensors = {"w": np.full(50_000, step, np.float32)}
    manifest = Manifest(agent="dqn", agent_config={}, env_config={}, step=step)
    # Every other one replaces its predecessor.
    save_checkpoint(parent / checkpoint_name(step // 2), tensors, manifest, {"s.bin": b"x" * 50000})
    print(step, flush=True)
"""


def test_the_newest_finished_checkpoint_survives_sigkill(tmp_path: Path) -> None:
    rng = random.Random(7)
    finished = 0
    for _ in range(8):
        writer = subprocess.Popen(
            [sys.executable, "-c", WRITER, str(tmp_path), str(finished)],
            stdout=subprocess.PIPE,
            text=True,
        )
        assert writer.stdout is not None
        assert writer.stdout.readline()
        time.sleep(rng.uniform(0.0, 0.15))
        writer.send_signal(signal.SIGKILL)
        rest = writer.communicate()[0].split()
        finished = max(finished + 1, *map(int, rest)) if rest else finished + 1
        newest = latest_checkpoint(tmp_path)
        assert newest is not None
        checkpoint = read_checkpoint(newest)
        step = checkpoint.manifest.step
        # One that was replacing its predecessor may be set aside for a moment.
        assert finished - 2 <= step <= finished + 1
        np.testing.assert_array_equal(checkpoint.tensors["w"], np.full(50_000, step, np.float32))
        finished = max(finished, step)
    manifest = Manifest(agent="dqn", agent_config={}, env_config={}, step=finished + 2)
    last = save_checkpoint(
        tmp_path / checkpoint_name(finished + 2), {"w": np.ones(1, np.float32)}, manifest
    )
    assert latest_checkpoint(tmp_path) == last
    assert all(path.name.startswith("step-") for path in tmp_path.iterdir())
