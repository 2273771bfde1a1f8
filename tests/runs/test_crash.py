"""A trainer is killed at random moments; its record and its checkpoints stay whole."""

import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

from singulate.checkpoints import read_checkpoint
from singulate.runs import RunDirectory, RunLock, RunReader, RunRecord, read_status

TRAINER = """
import sys
from pathlib import Path
import numpy as np
from singulate.checkpoints import Manifest, save_checkpoint
from singulate.geometry import Block, Push, standing_pose
from singulate.runs import Heartbeat, PushRecord, RunDirectory, RunLock, RunReader, RunRecord
from singulate.runs import RunStatus
run = RunDirectory(Path(sys.argv[1])).open()
poses = tuple(standing_pose(Block(0.3 * i, 0.1)) for i in range(3))
push = Push((0.1, 0.2), (0.0, 1.0), 0.5)
with RunLock(run.path), Heartbeat(run.path, RunStatus(state="running"), 0.01):
    with RunRecord(run.path) as record:
        step = RunReader(run.path).last_step()
        while True:
            for _ in range(20):
                step += 1
                terms = {"start": 1.0, "distance": 0.0, "inside": 0.0, "success": 0.0}
                record.add_push(
                    PushRecord(step, step, push, float(step), terms, False, "empty", poses)
                )
            record.add_metrics(step, {"reward": float(step)})
            record.flush()
            manifest = Manifest(agent="dqn", agent_config={}, env_config={}, step=step)
            tensors = {"w": np.full(20_000, step, np.float32)}
            save_checkpoint(run.checkpoint_path(step), tensors, manifest)
            print(step, flush=True)
"""


def test_record_and_checkpoints_survive_sigkill(run_dir: Path) -> None:
    rng = random.Random(11)
    run = RunDirectory(run_dir)
    reader = RunReader(run_dir)
    for _ in range(6):
        trainer = subprocess.Popen(
            [sys.executable, "-c", TRAINER, str(run_dir)], stdout=subprocess.PIPE, text=True
        )
        assert trainer.stdout is not None
        first = trainer.stdout.readline()
        time.sleep(rng.uniform(0.0, 0.2))
        trainer.send_signal(signal.SIGKILL)
        finished = int((first + trainer.communicate()[0]).split()[-1])

        status = read_status(run_dir)
        assert status.state == "died"
        assert f"process {trainer.pid} ended without a word" in status.error

        assert finished <= reader.count_pushes() <= finished + 20
        assert reader.count_pushes() % 20 == 0
        assert reader.last_pushes(1)[0].reward == reader.last_step()
        assert reader.metrics_since("reward").steps[-1] == reader.last_step()
        _check_integrity(run.record_path)

        newest = run.latest_checkpoint()
        assert newest is not None
        checkpoint = read_checkpoint(newest)
        assert finished <= checkpoint.manifest.step <= reader.last_step()
        assert (checkpoint.tensors["w"] == checkpoint.manifest.step).all()
        with RunLock(run_dir), RunRecord(run_dir) as record:
            record.rewind(checkpoint.manifest.step)
        assert reader.last_step() == checkpoint.manifest.step


def test_a_commit_that_was_cut_short_is_undone_by_the_reader(
    run_dir: Path, tmp_path: Path, make_push
) -> None:
    with RunRecord(run_dir) as record:
        for step in range(1, 201):
            record.add_push(make_push(step))
    path = run_dir / "record.sqlite"
    writer = sqlite3.connect(path, isolation_level=None)
    writer.execute("PRAGMA cache_size = 1")  # so that pages reach the file before the commit
    writer.execute("BEGIN")
    writer.execute("UPDATE pushes SET reward = -1, outcome = 'empty'")
    killed = RunDirectory(tmp_path / "killed").create({}).path
    for name in ("record.sqlite-journal", "record.sqlite"):
        shutil.copy(run_dir / name, killed / name)
    writer.execute("ROLLBACK")
    writer.close()
    assert (killed / "record.sqlite").read_bytes() != path.read_bytes()

    reader = RunReader(killed)
    assert reader.count_pushes() == 200
    assert all(push.reward > 0.0 for push in reader.last_pushes(200))
    assert not (killed / "record.sqlite-journal").exists()


def _check_integrity(path: Path) -> None:
    connection = sqlite3.connect(path)
    assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    connection.close()
