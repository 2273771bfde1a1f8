import json
from pathlib import Path

import pytest

from app.panels.context import PanelContext
from app.panels.paper import PaperPanel
from app.reproduction import Claim, read_reproduction
from singulate.exceptions import SingulateError

ENTRY = {
    "key": "state",
    "statement": "Maps <b>win</b>.",
    "source": "section 5.2",
    "measure": "",
    "verdict": "not held",
    "numbers": [{"name": "map", "values": [0.5, 0.25, 1.0]}],
    "note": "",
    "reason": "chance",
}


@pytest.fixture
def made(tmp_path: Path) -> Path:
    (tmp_path / "fig1.png").write_bytes(b"one")
    (tmp_path / "fig3.png").write_bytes(b"three")
    (tmp_path / "ideas.png").write_bytes(b"ideas")
    (tmp_path / "claims.json").write_text(json.dumps({"claims": [ENTRY]}))
    return tmp_path


def test_figures_and_claims_are_read(made: Path) -> None:
    found = read_reproduction(made)
    assert {key: path.name for key, path in found.figures.items()} == {
        "1": "fig1.png",
        "3": "fig3.png",
        "ideas": "ideas.png",
    }
    numbers = ("map: 0.5 (0.25 to 1, 3 seeds)",)
    assert found.claims == (
        Claim("Maps <b>win</b>.", "section 5.2", "not held", numbers, "chance"),
    )


def test_nothing_made_is_said(context: PanelContext, tmp_path: Path) -> None:
    assert read_reproduction(tmp_path / "absent").figures == {}
    panel = PaperPanel(context, tmp_path)
    assert "singulate reproduce all" in panel.claims.content and not panel.figures.visible


@pytest.mark.parametrize("text", ["[]", "{", '{"claims": [{}]}', '{"claims": [3]}'])
def test_unreadable_claims_are_told_and_end_nothing(
    text: str, context: PanelContext, made: Path
) -> None:
    (made / "claims.json").write_text(text)
    with pytest.raises(SingulateError, match="claims"):
        read_reproduction(made)
    assert "not the claims" in PaperPanel(context, made).claims.content


def test_a_figure_opens_and_one_that_is_gone_is_reported(
    context: PanelContext, made: Path, reports: list[str]
) -> None:
    panel = PaperPanel(context, made)
    assert "Maps &lt;b&gt;win" in panel.claims.content
    assert 'alt="Figure 3"' in panel.open(1).content and "dGhyZWU=" in panel.open(1).content
    assert 'alt="Ideas"' in panel.open(2).content and "aWRlYXM=" in panel.open(2).content
    (made / "fig1.png").unlink()
    assert panel.open(0) is None
    assert len(reports) == 1 and "fig1.png" in reports[0]
