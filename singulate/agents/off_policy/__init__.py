"""What SAC and TD3 have in common: an actor that pushes, and two critics that judge pushes."""
