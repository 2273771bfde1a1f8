"""Makes the environments known to Gymnasium, without importing them (or Bullet)."""

import gymnasium

ENV_ID = "singulate/Push-v0"


def register_environments() -> None:
    """Register ``singulate/Push-v0``; a second call changes nothing."""
    if ENV_ID not in gymnasium.registry:
        gymnasium.register(id=ENV_ID, entry_point="singulate.envs.push_env:PushEnv")
