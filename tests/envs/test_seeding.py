"""Seeds of training and evaluation scenes."""

import pytest

from singulate.envs import scene_seed
from singulate.exceptions import InvalidValueError


def test_training_and_evaluation_never_share_a_scene():
    training = {scene_seed("training", run, i) for run in range(20) for i in range(200)}
    evaluation = {scene_seed("evaluation", run, i) for run in range(20) for i in range(200)}
    assert len(training) == len(evaluation) == 4000
    assert all(seed % 2 == 0 for seed in training)
    assert all(seed % 2 == 1 for seed in evaluation)


def test_scenes_of_data_sets_are_neither_trained_nor_evaluated_on():
    dataset = {scene_seed("dataset", run, i) for run in range(20) for i in range(200)}
    assert len(dataset) == 4000
    assert min(dataset) >= 2**63 > scene_seed("training", 0, 0)
    assert max(dataset) < 2**64


def test_seeds_are_the_same_in_every_version():
    assert scene_seed("training", 0, 0) == 7896617691693857886
    assert scene_seed("evaluation", 7, 3) == 2530781778362038831
    assert scene_seed("dataset", 3, 3) == 15476169122101971916


@pytest.mark.parametrize(
    ("stream", "seed", "index"), [("training", -1, 0), ("training", 0, -1), ("test", 0, 0)]
)
def test_a_bad_seed_is_refused(stream, seed, index):
    with pytest.raises(InvalidValueError):
        scene_seed(stream, seed, index)
