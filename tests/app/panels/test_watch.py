import numpy as np

from app.panels.watch import Throttle, Watch


def test_the_first_look_is_a_change_and_the_same_again_is_not():
    watch = Watch()
    assert watch.has_changed(1, "a", None)
    assert not watch.has_changed(1, "a", None)
    assert watch.has_changed(2, "a", None)


def test_arrays_are_the_same_only_if_they_are_the_same_object():
    watch, array = Watch(), np.zeros(3)
    watch.has_changed(array)
    assert not watch.has_changed(array)
    assert watch.has_changed(array.copy())
    assert watch.has_changed(None)


def test_one_and_true_are_different():
    watch = Watch()
    watch.has_changed(1)
    assert watch.has_changed(True)


def test_a_throttle_lets_one_call_through_each_interval():
    throttle = Throttle(0.25)
    assert [throttle.is_due(now) for now in (0.0, 0.1, 0.24, 0.25, 0.3, 0.6)] == [
        True, False, False, True, False, True,
    ]  # fmt: skip
