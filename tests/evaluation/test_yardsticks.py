import json

import pytest

from singulate.cli import main
from singulate.evaluation.yardsticks import YARDSTICKS


@pytest.mark.parametrize("name", YARDSTICKS)
def test_every_yardstick_stands_where_a_checkpoint_could(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    options = ["--scenario", "fixed-2", "--episodes", "3", "--workers", "1", "--json"]
    assert main(["evaluate", name, *options]) == 0
    result = json.loads(capsys.readouterr().out)
    assert (result["agent"], result["num_episodes"]) == (name, 3)
    assert result["is_sampled"] == name.startswith("random")
