from singulate.rewards import inside_reward


def test_only_a_start_inside_counts() -> None:
    assert inside_reward(True) == 1.0
    assert inside_reward(False) == 0.0
