"""Soft actor-critic with a squashed Gaussian over continuous pushes."""
