"""Environments of a training in processes of their own, each watched and replaced.

The processes load neither torch nor stable-baselines3.
"""
