from app.fields.colormaps import SEQUENTIAL
from app.fields.legend import legend_html


def test_the_legend_tells_both_ends_the_middle_and_the_unit():
    html = legend_html((-100.0, 1300.0), SEQUENTIAL, "reward")
    for text in (">-100<", ">600<", ">1300 reward<", SEQUENTIAL.css_gradient):
        assert text in html
