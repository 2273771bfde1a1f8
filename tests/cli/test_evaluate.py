import json

import pytest

from singulate.cli import main
from singulate.paths import shipped_checkpoints_directory


def test_ppo_draws_its_pushes_unless_it_is_told_to_be_greedy(
    capsys: pytest.CaptureFixture[str],
) -> None:
    checkpoint = str(shipped_checkpoints_directory() / "ppo-fixed-2")
    found = {}
    for option in ("", "--sample", "--greedy"):
        options = ["--episodes", "20", "--workers", "1", "--json", *filter(None, [option])]
        assert main(["evaluate", checkpoint, *options]) == 0
        found[option] = json.loads(capsys.readouterr().out)
    assert found[""] == found["--sample"]
    assert [each["is_sampled"] for each in found.values()] == [True, True, False]
    # Its mean push lies on the seam between the blocks; draws beside it separate them.
    assert found["--greedy"]["num_successes"] == 0
    assert found["--sample"]["num_successes"] > 8
