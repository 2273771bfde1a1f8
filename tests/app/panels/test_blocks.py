from app.commands import AddBlock, RemoveBlock, TurnBlock
from app.panels.blocks import TURN, BlocksPanel
from singulate.geometry import Block, standing_pose


def test_buttons_take_the_block_that_was_moved_last(context, make_scene, submitted):
    panel = BlocksPanel(context)
    panel.press(1)
    panel.update(make_scene(poses=tuple(standing_pose(Block(x, 0.0, 0.2)) for x in (0.0, 0.5))))
    panel.press(0)
    panel.press(1)
    panel.chosen = 0
    panel.press(1)
    panel.press(2)
    panel.press(2)
    assert submitted == [
        AddBlock(), TurnBlock(1, TURN), TurnBlock(0, TURN), RemoveBlock(0), RemoveBlock(1),
    ]  # fmt: skip
