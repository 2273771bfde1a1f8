from app.fields.drape import drape
from app.panels.table_legend import TableLegend


def test_the_legend_names_what_lies_on_the_table_and_how_far_it_is(context, make_snapshot):
    legend, snapshot = TableLegend(context), make_snapshot()
    legend.update(snapshot, drape(snapshot, context.preferences, context.workspace))
    assert "True reward, best direction" in legend.legend.content
    assert "25 % done" in legend.legend.content


def test_an_empty_table_has_no_colours(context, make_snapshot):
    legend = TableLegend(context)
    context.preferences.field = "none"
    legend.update(make_snapshot(), None)
    assert "Nothing lies on the table" in legend.legend.content
    assert "singulate-legend" not in legend.legend.content
