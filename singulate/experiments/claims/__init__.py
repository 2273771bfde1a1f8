"""The paper's claims, each with a measure and a rule that decides whether it holds here.

To add one: a file in this folder with a function from `Evidence` to `Claim`, and one line in
`singulate.experiments.claims.registry`.
"""
