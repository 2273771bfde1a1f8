"""Trust region policy optimisation with PPO's Gaussian over continuous pushes (section 6)."""
