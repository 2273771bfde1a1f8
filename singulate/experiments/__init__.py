"""Experiments whose results are committed: what they measure, and how."""
