"""Agents: how a push is chosen from what the camera sees.

Importing this package pulls no torch; building or loading a model does.
"""
