"""Training: a process of its own that writes a run directory and reads a control channel.

Importing this package pulls no torch; `singulate.training.trainer` does.
"""
