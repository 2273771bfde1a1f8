"""Proximal policy optimisation with a Gaussian over continuous pushes (sections 3 and 5)."""
