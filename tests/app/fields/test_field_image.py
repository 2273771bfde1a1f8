import numpy as np

from app.fields.colormaps import SEQUENTIAL
from app.fields.field_image import (
    best_cell,
    field_image,
    picture_image,
    segment_image,
    value_span,
)


def test_values_map_onto_the_whole_colour_map():
    image = field_image(np.array([[0.0, 5.0, 10.0]]), (0.0, 10.0), SEQUENTIAL)
    assert image[0, 0, :3].tolist() == SEQUENTIAL.table[0].tolist()
    assert image[0, 1, :3].tolist() == SEQUENTIAL.table[128].tolist()
    assert image[0, 2, :3].tolist() == SEQUENTIAL.table[255].tolist()
    assert (image[..., 3] == 255).all()


def test_cells_without_a_value_are_transparent():
    image = field_image(np.array([[np.nan, np.inf, 1.0]]), (0.0, 1.0), SEQUENTIAL, opacity=0.5)
    assert image[0, :, 3].tolist() == [0, 0, 128]


def test_values_beyond_the_span_are_clipped():
    image = field_image(np.array([[-5.0, 50.0]]), (0.0, 10.0), SEQUENTIAL)
    assert image[0, 0, :3].tolist() == SEQUENTIAL.table[0].tolist()
    assert image[0, 1, :3].tolist() == SEQUENTIAL.table[255].tolist()


def test_fading_fields_leave_the_table_visible_where_they_are_low():
    image = field_image(np.array([[0.0, 1.0]]), (0.0, 1.0), SEQUENTIAL, fades=True)
    assert image[0, 0, 3] < 50
    assert image[0, 1, 3] == 255


def test_span_leaves_out_what_is_not_finite():
    assert value_span(np.array([np.nan, 2.0, -np.inf, 5.0])) == (2.0, 5.0)


def test_span_of_several_maps_holds_all_of_them():
    assert value_span(np.array([1.0, 2.0]), np.array([-3.0])) == (-3.0, 2.0)


def test_diverging_span_is_symmetric():
    assert value_span(np.array([-1.0, 4.0]), is_diverging=True) == (-4.0, 4.0)


def test_span_is_never_empty():
    for values in (np.array([7.0, 7.0]), np.array([np.nan]), np.zeros(3)):
        low, high = value_span(values)
        assert low < high


def test_segments_have_different_colours_and_no_background():
    labels = np.array([[0, 1, 2]], np.int32)
    image = segment_image(labels)
    assert image[0, :, 3].tolist() == [0, 255, 255]
    assert image[0, 1, :3].tolist() != image[0, 2, :3].tolist()


def test_more_segments_than_colours_start_the_palette_again():
    image = segment_image(np.array([[1, 9]], np.int32))
    assert image[0, 0].tolist() == image[0, 1].tolist()


def test_pictures_keep_their_colours():
    rgb = np.arange(12, dtype=np.uint8).reshape(2, 2, 3)
    image = picture_image(rgb, 0.5)
    assert (image[..., :3] == rgb).all()
    assert (image[..., 3] == 128).all()


def test_best_cell_is_row_and_column_of_the_largest_finite_value():
    values = np.array([[np.nan, 3.0], [9.0, np.inf]])
    assert best_cell(values) == (1, 0)
    assert best_cell(np.full((2, 2), np.nan)) is None
