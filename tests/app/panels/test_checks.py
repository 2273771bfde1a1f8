import math

import pytest

from app.panels.checks import flag, number, one_of, whole_number
from singulate.exceptions import InvalidValueError


@pytest.mark.parametrize("value", ["c", "", None, 1, ["a"], "A"])
def test_texts_that_are_not_offered_are_refused(value: object):
    with pytest.raises(InvalidValueError, match=r"letter: .* is not allowed; allowed: a, b"):
        one_of("letter", ("a", "b"))(value)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e9, 10**400, "1", None, True])
def test_numbers_out_of_range_are_refused(value: object):
    with pytest.raises(InvalidValueError, match="a number from 0 to 8"):
        number("speed", 0.0, 8.0)(value)


@pytest.mark.parametrize("value", [math.nan, math.inf, 1.5, -1, 11, "3", None, True])
def test_anything_but_a_whole_number_in_range_is_refused(value: object):
    with pytest.raises(InvalidValueError, match="a whole number from 0 to 10"):
        whole_number("seed", 0, 10)(value)


@pytest.mark.parametrize("value", [0, 1, "true", None])
def test_only_true_and_false_are_flags(value: object):
    with pytest.raises(InvalidValueError, match="true or false"):
        flag("watch")(value)


def test_good_values_come_back_in_their_type():
    assert one_of("letter", ("a", "b"))("b") == "b"
    assert number("speed", 0.0, 8.0)(8) == 8.0
    assert whole_number("seed", 0, 10)(3.0) == 3
    assert flag("watch")(True) is True
