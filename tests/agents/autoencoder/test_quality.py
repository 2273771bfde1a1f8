import numpy as np

from singulate.agents.autoencoder.quality import compare_maps


def test_quality_by_hand() -> None:
    """Of two object pixels one is found, and one is seen where there is none."""
    maps = np.array([[[-1.0, -1.0, 1.0, 2.0]]], np.float32)
    made = np.array([[[-1.0, 0.5, -0.5, 2.0]]], np.float32)
    quality = compare_maps(made, maps)
    assert quality.mean_absolute_error_px == 0.75
    assert quality.object_pixels_found == 0.5
    assert quality.mask_overlap == round(1 / 3, 4)
    assert quality.num_scenes == 1
