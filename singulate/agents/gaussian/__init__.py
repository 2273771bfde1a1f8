"""What agents that draw their pushes from one Gaussian have in common (section 5.3)."""
