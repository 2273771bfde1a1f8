import pytest

from singulate.training.metrics import SMOOTHING_EPISODES, EpisodeMetrics

TERMS = {"start": 0.5, "success": 0.0}


def test_pushes_add_up_to_episodes() -> None:
    metrics = EpisodeMetrics()
    metrics.add_push(100.0, TERMS, is_success=False, is_done=False)
    assert metrics.collect() == {}
    metrics.add_push(900.0, {"start": 1.0, "success": 1.0}, is_success=True, is_done=True)
    metrics.add_push(-100.0, TERMS, is_success=False, is_done=True)
    values = metrics.collect()
    assert values["rollout/ep_rew_mean"] == 450.0
    assert values["rollout/success_rate"] == 0.5
    assert values["rollout/ep_len_mean"] == 1.5
    assert values["reward_terms/start"] == 0.75


def test_smooth_values_cover_the_last_thousand_episodes_only() -> None:
    metrics = EpisodeMetrics()
    for index in range(SMOOTHING_EPISODES + 250):
        metrics.add_push(float(index < 250), TERMS, is_success=index >= 1000, is_done=True)
    assert metrics.success_rate == pytest.approx(0.25)
    assert metrics.mean_reward == pytest.approx(0.0, abs=1e-9)
