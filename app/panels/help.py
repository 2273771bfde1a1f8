"""The list of keys."""

KEYS = (
    ("Space", "pause the scene, or let it go on"),
    ("N", "one step of the push"),
    ("R", "reset the scene"),
    ("Z", "undo"),
    ("1 2 3 4", "the next push goes up, right, down, left"),
    ("P", "let the agent push"),
    ("T", "train, pause or resume training"),
    ("F / G", "next / previous field on the table"),
    ("C", "view from the top"),
    ("X", "save a picture"),
    ("H", "this help"),
)

HELP_TEXT = (
    "**Click** the table to push from there in the chosen direction, or **drag** an arrow. "
    "**Drag a block** to move it, with Shift to turn it: every field follows. "
    "Drag beside the table to turn the view; W A S D Q E and the arrow keys move it.\n\n"
    "| Key | What it does |\n|---|---|\n"
    + "\n".join(f"| **{key}** | {text} |" for key, text in KEYS)
    + "\n\n"
    "Ctrl + K lists all commands. Everyone who opens this page sees the same table; fields, "
    "tabs and theme are your own."
)
