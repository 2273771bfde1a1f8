from app.panels.marked_choice import MarkedChoice, add_switch


def test_only_the_shown_one_is_marked(context):
    choice = MarkedChoice(context.gui, "Size", ("s", "l"), ("[s]", "[l]"), lambda index: None)
    assert choice.handle.options == ("s", "l")
    choice.show(1)
    assert choice.handle.options == ("s", "[l]")
    choice.show(0)
    assert choice.handle.options == ("[s]", "l")


def test_a_switch_names_its_two_states(context):
    switch = add_switch(context.gui, "Theme", lambda is_light: None, ("light", "dark"))
    switch.show(1)
    assert switch.handle.options == ("○ light", "● dark")
