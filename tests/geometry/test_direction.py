from singulate.geometry import Direction


def test_order_of_the_paper() -> None:
    assert [d.label for d in Direction] == ["up", "right", "down", "left"]
    assert [int(d) for d in Direction] == [0, 1, 2, 3]


def test_vectors_in_the_world_frame() -> None:
    assert [d.vector for d in Direction] == [(0, 1), (1, 0), (0, -1), (-1, 0)]
