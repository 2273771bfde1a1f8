import numpy as np
import pytest

from singulate.agents.baselines.presumed_blocks import PresumedBlock, presume_blocks


def squares(*corners: tuple[int, int, int]) -> np.ndarray:
    mask = np.zeros((64, 64), dtype=np.bool_)
    for row, col, side in corners:
        mask[row : row + side, col : col + side] = True
    return mask


@pytest.mark.parametrize(
    "corners",
    [
        [(10, 10, 6)],
        [(10, 10, 6), (10, 16, 6)],
        [(11, 10, 5), (10, 15, 7), (11, 22, 6)],
        [(10, 11, 5), (15, 10, 7)],
        [(10, 10, 6), (16, 10, 6), (16, 16, 6)],
        [(0, 0, 8), (56, 56, 8)],
    ],
)
def test_rows_columns_and_corners_fall_into_their_squares(
    corners: list[tuple[int, int, int]],
) -> None:
    expected = {PresumedBlock(r + (s - 1) / 2, c + (s - 1) / 2, s) for r, c, s in corners}
    assert set(presume_blocks(squares(*corners))) == expected


def test_no_object_is_no_block_and_specks_are_none_either() -> None:
    assert presume_blocks(squares()) == []
    assert presume_blocks(squares((5, 5, 2))) == []
