from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.autoencoder.quality import compare_maps, measure_quality, reconstruct
from singulate.agents.autoencoder.training import make_autoencoder, train_autoencoder
from singulate.checkpoints.reading import read_manifest
from singulate.exceptions import InvalidValueError


def test_the_loss_falls(trained: Any) -> None:
    assert len(trained.losses) == 200
    assert np.mean(trained.losses[-20:]) < 0.3 * np.mean(trained.losses[:20])


def test_unseen_maps_come_back_better_than_the_mean_map(trained: Any) -> None:
    mean = np.broadcast_to(trained.maps.mean(axis=0), trained.unseen.shape)
    quality = measure_quality(trained.network, trained.unseen)
    baseline = compare_maps(mean, trained.unseen)
    assert quality.num_scenes == len(trained.unseen)
    assert quality.mean_absolute_error_px < 0.5 * baseline.mean_absolute_error_px


def test_codes_are_standardised_over_the_maps_of_the_training(trained: Any) -> None:
    with torch.no_grad():
        codes = trained.network.encoder(torch.from_numpy(trained.maps))
    torch.testing.assert_close(codes.mean(dim=0), torch.zeros(32), atol=1e-3, rtol=0)
    torch.testing.assert_close(codes.std(dim=0), torch.ones(32), atol=1e-2, rtol=0)


def test_generator_and_settings_decide_the_weights(trained: Any) -> None:
    config = AutoencoderConfig(num_updates=5)
    torch.manual_seed(3)
    before = torch.get_rng_state()
    made = [
        train_autoencoder(config, trained.maps, np.random.default_rng(seed))[0]
        for seed in (4, 4, 5)
    ]
    outputs = [reconstruct(network, trained.unseen[:4]) for network in made]
    assert np.array_equal(outputs[0], outputs[1])
    assert not np.array_equal(outputs[0], outputs[2])
    assert torch.equal(torch.get_rng_state(), before)  # torch's own generator is left alone


def test_scenes_training_quality_and_progress_in_one(tmp_path: Path) -> None:
    steps: dict[str, tuple[int, int]] = {}

    def note(step: str, done: int, total: int) -> None:
        steps[step] = (done, total)

    config = AutoencoderConfig("random-2", num_scenes=6, num_updates=3, batch_size=2)
    quality = make_autoencoder(config, 4, tmp_path / "ae", note)
    assert steps == {"Scenes": (10, 10), "Training": (3, 3)}
    manifest = read_manifest(tmp_path / "ae")
    assert (manifest.agent_config["scenario"], manifest.step) == ("random-2", 3)
    assert manifest.notes["quality"] == quality.to_dict()
    assert quality.num_scenes == 4


@pytest.mark.parametrize(
    ("values", "key"),
    [
        ({"scenario": "moon-2"}, "scenario"),
        ({"num_scenes": 0}, "scenes"),
        ({"num_updates": 1.5}, "updates"),
        ({"batch_size": True}, "batch_size"),
        ({"learning_rate": 0.0}, "learning_rate"),
        ({"seed": -1}, "seed"),
    ],
)
def test_bad_settings_name_the_key(values: dict[str, object], key: str) -> None:
    with pytest.raises(InvalidValueError, match=key):
        AutoencoderConfig(**values)  # type: ignore[arg-type]


def test_what_decides_the_weights_decides_the_key() -> None:
    keys = {AutoencoderConfig(seed=seed).key for seed in (0, 0, 1)}
    assert len(keys) == 2
