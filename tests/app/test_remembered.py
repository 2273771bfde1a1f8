import pytest

from app.preferences import Preferences
from app.remembered import restore, to_text


def test_choices_come_back():
    kept = Preferences(field="q", choice="left", opacity=0.4, is_dark=True, span="each field")
    fresh = Preferences()
    restore(fresh, to_text(kept))
    assert fresh == kept


def test_what_is_not_kept_stays():
    fresh = Preferences(window_size=256)
    restore(fresh, to_text(Preferences(window_size=4096)))
    assert fresh.window_size == 256


@pytest.mark.parametrize(
    "text",
    [
        "", "{", "null", "[1]", "42", "[" * 5000, '{"field": "mars"}', '{"opacity": 7}',
        '{"opacity": NaN}', '{"is_dark": 1, "choice": ["up"]}', '{"direction": 3}',
    ],
)  # fmt: skip
def test_damaged_choices_change_nothing(text: str):
    fresh = Preferences()
    restore(fresh, text)
    assert fresh == Preferences()


def test_good_choices_beside_damaged_ones_are_taken():
    fresh = Preferences()
    restore(fresh, '{"field": "mask", "opacity": "full"}')
    assert fresh == Preferences(field="mask")
