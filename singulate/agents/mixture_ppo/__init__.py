"""PPO whose policy is a mixture of Gaussians over continuous pushes.

The first of the two remedies of the paper's conclusion, in its plainest form: "an approach with a
multimodal policy space" (section 6), with the Gaussian of PPO kept and multiplied.
"""
