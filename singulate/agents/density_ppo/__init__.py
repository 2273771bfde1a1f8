"""What the PPO agents with a density of pushes of their own have in common.

Each brings a network that says a density and a value for a scene; the actor and critic around it,
the schedules of the training, the settings and the loaded policy are here.
"""
