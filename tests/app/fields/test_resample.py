import numpy as np

from app.fields.resample import nearest, nearest_stack


def test_cells_are_repeated():
    values = np.array([[1, 2], [3, 4]])
    assert nearest(values, 4).tolist() == [[1, 1, 2, 2], [1, 1, 2, 2], [3, 3, 4, 4], [3, 3, 4, 4]]


def test_a_coarser_map_takes_the_cell_under_its_centre():
    values = np.arange(16).reshape(4, 4)
    assert nearest(values, 2).tolist() == [[5, 7], [13, 15]]


def test_pictures_keep_their_channels():
    assert nearest(np.zeros((10, 10, 4), np.uint8), 320).shape == (320, 320, 4)


def test_stacks_are_resampled_map_by_map():
    stack = np.arange(8, dtype=np.float32).reshape(2, 2, 2)
    for index in range(2):
        assert (nearest_stack(stack, 6)[index] == nearest(stack[index], 6)).all()


def test_resolutions_that_do_not_divide_each_other_stay_in_place():
    stack = np.zeros((4, 10, 10), np.float32)
    stack[:, 2, 1] = 1.0
    rows, cols = np.nonzero(nearest_stack(stack, 64)[0])
    assert abs(rows.mean() / 64 - 0.25) < 0.01
    assert abs(cols.mean() / 64 - 0.15) < 0.01
