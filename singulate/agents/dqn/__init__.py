"""Deep Q-learning over the paper's 10 x 10 x 4 discrete pushes (section 5.4)."""
