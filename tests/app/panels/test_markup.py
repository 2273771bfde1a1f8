import numpy as np

from app.panels.markup import dimmed, picture, show, table, title


def test_texts_are_escaped():
    for html in (title("<a>", "<b>"), dimmed("<c>")):
        assert "&lt;" in html and "<a>" not in html and "<b>" not in html and "<c>" not in html


def test_a_long_note_goes_below_its_heading():
    assert "flex" in title("Q", "short")
    assert title("Q", "x" * 60) == title("Q") + dimmed("x" * 60)


def test_alternative_texts_cannot_leave_their_attribute():
    html = picture(np.zeros((2, 2, 4), np.uint8), 'x" onload="alert(1)')
    assert 'onload="' not in html


def test_tables_have_their_head_and_rows():
    html = table([("up", "1"), ("down", "2")], ("", "value"))
    assert html.count("<tr>") == 3
    assert html.index("value") < html.index("up") < html.index("down")


def test_the_same_text_is_not_sent_twice(context):
    handle = context.gui.add_html("old")
    before = handle.content
    show(handle, "".join(("o", "ld")))
    assert handle.content is before
    show(handle, "new")
    assert handle.content == "new"
