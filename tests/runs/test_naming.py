import re
from pathlib import Path

from singulate.runs import new_run_directory


def test_names_tell_time_agent_and_scenario_and_never_collide(tmp_path: Path) -> None:
    paths = []
    for _ in range(3):
        paths.append(new_run_directory(tmp_path / "runs", "dqn", "random-2"))
        assert re.fullmatch(r"\d{8}-\d{6}-dqn-random-2(-[23])?", paths[-1].name)
        paths[-1].mkdir(parents=True)
    assert len(set(paths)) == 3
