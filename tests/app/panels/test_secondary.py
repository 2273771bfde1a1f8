from app.panels.secondary import DARK, LIGHT, SecondaryButtons


def test_quiet_buttons_follow_the_theme(context):
    buttons = SecondaryButtons(context.gui, is_dark=False)
    early = buttons.add("Save")
    assert early.color == LIGHT
    buttons.paint(is_dark=True)
    assert early.color == buttons.add("Stop").color == DARK
