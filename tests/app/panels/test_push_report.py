from dataclasses import replace

from app.panels.push_report import PushReportView, push_report_html


def test_before_the_first_push_it_says_how_to_push():
    assert "Click the table" in push_report_html(None)


def test_terms_prediction_and_error_are_listed(make_report):
    html = push_report_html(make_report())
    for text in ("singulated", "right from (0.25, -0.50) m", ">214<", ">1000<", ">800<", "1264",
                 ">-464<", "before: 1 part<", "after: 2 parts<"):  # fmt: skip
        assert text in html
    assert html.count("<img") == 2


def test_zero_has_no_sign(make_report):
    report = make_report()
    near = replace(report, push=replace(report.push, start=(-0.004, 0.0049)))
    assert "from (0.00, 0.00) m" in push_report_html(near)


def test_a_policy_that_cannot_predict_leaves_a_dash(make_report):
    html = push_report_html(make_report(predicted=None))
    assert "\N{EN DASH}" in html
    assert "error" not in html


def test_names_from_outside_cannot_bring_markup(make_report):
    html = push_report_html(make_report(by="<script>x</script>", outcome="<b>"))
    assert "<script>" not in html


def test_a_prediction_that_comes_late_is_shown(context, make_report):
    view = PushReportView(context.gui)
    report = make_report(predicted=None)
    view.update(report)
    view.update(replace(report, predicted=812.0))
    assert ">812<" in view.html.content


def test_one_is_told_of_by_name_to_the_others_only(context, make_report):
    report = make_report(by="visitor 1")
    own, other = (PushReportView(context.gui, name) for name in ("visitor 1", "visitor 2"))
    for view in (own, other):
        view.update(report)
    assert "you: right" in own.html.content and "visitor" not in own.html.content
    assert "visitor 1: right" in other.html.content


def test_the_page_changes_only_with_another_push(context, make_report):
    view = PushReportView(context.gui)
    report = make_report()
    view.update(report)
    assert "singulated" in view.html.content
    view.html.content = "left alone"
    view.update(report)
    assert view.html.content == "left alone"
    view.update(make_report(reward=-100.0, outcome="inside"))
    assert "inside a block" in view.html.content
