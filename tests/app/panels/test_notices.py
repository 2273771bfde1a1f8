from app.panels.notices import NoticesView, notices_html
from app.snapshot import Notice


def test_texts_are_escaped_and_only_the_newest_are_shown():
    notices = tuple(Notice(i, f"<i>number {i}</i>") for i in range(5))
    html = notices_html(notices)
    assert "&lt;i&gt;number 4" in html and "number 2" in html
    assert "number 1" not in html
    assert "and 2 more" in html


def test_the_box_is_there_only_with_notices(context, make_snapshot):
    view = NoticesView(context)
    view.update(make_snapshot())
    assert not view.html.visible
    view.update(make_snapshot(notices=(Notice(1, "the trainer died"),)))
    assert view.html.visible and "the trainer died" in view.html.content
    view.update(make_snapshot())
    assert not view.html.visible
