"""A small code of the distance map, learnt without rewards: a state for agents (paper, section 6).

`singulate.agents.frozen_encoder` is how an agent looks through it.
"""
