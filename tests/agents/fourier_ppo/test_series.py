import math

import pytest
import torch

from singulate.agents.fourier_ppo.series import coefficients_of, cosine_basis, series_at


@pytest.mark.parametrize(("num_points", "num_frequencies"), [(16, 16), (32, 24), (64, 5)])
def test_the_basis_is_orthonormal(num_points: int, num_frequencies: int) -> None:
    basis = cosine_basis(num_points, num_frequencies)
    assert torch.allclose(basis.T @ basis, torch.eye(num_frequencies), atol=1e-5)


def test_all_coefficients_give_a_map_back() -> None:
    values = torch.randn(3, 4, 16, 16)
    assert torch.allclose(series_at(coefficients_of(values, 16), 16), values, atol=1e-4)


def test_a_constant_map_is_its_own_first_coefficient() -> None:
    coefficients = coefficients_of(torch.full((32, 32), 3.0), 4)
    expected = torch.zeros(4, 4)
    expected[0, 0] = 3.0
    assert torch.allclose(coefficients, expected, atol=1e-5)
    assert torch.allclose(series_at(coefficients, 64), torch.full((64, 64), 3.0), atol=1e-4)


def test_a_cosine_is_continued_between_the_points_and_none_is_left_of_shorter_ones() -> None:
    def wave(num_points: int, frequency: int) -> torch.Tensor:
        middle = (torch.arange(num_points) + 0.5) / num_points
        return torch.cos(math.pi * frequency * middle)[:, None].expand(-1, num_points)

    assert torch.allclose(series_at(coefficients_of(wave(16, 5), 8), 64), wave(64, 5), atol=1e-4)
    assert coefficients_of(wave(16, 9), 8).abs().max() < 1e-5
