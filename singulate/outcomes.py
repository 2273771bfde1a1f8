"""What can become of a push, in one word each."""

SIMULATION_ERROR = "simulation_error"
"""The physics went wrong; the scene is as before the push."""

OUTCOMES = ("success", "empty", "inside", "off_table", "not_separated", SIMULATION_ERROR)
"""``empty`` moved nothing by 5 mm; ``inside`` started on a block."""
