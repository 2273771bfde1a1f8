"""Actor and critic of a Gaussian agent."""

from typing import Protocol

from singulate.agents.network import policy_arguments


class GaussianSettings(Protocol):
    """Settings that every Gaussian agent has.

    Attributes:
        learning_rate: Step size of Adam.
        net_arch: Widths of the fully connected layers, of actor and critic each.
        log_std_init: Logarithm of the Gaussian's standard deviation at the start.
        encoder: Directory of an autoencoder whose code is the agent's state, or None.
    """

    @property
    def learning_rate(self) -> float: ...  # noqa: D102

    @property
    def net_arch(self) -> tuple[int, ...]: ...  # noqa: D102

    @property
    def log_std_init(self) -> float: ...  # noqa: D102

    @property
    def encoder(self) -> str | None: ...  # noqa: D102


def network_arguments(config: GaussianSettings, observation: str) -> dict[str, object]:
    """Arguments of stable-baselines3's actor-critic policy.

    Args:
        config: The agent's settings.
        observation: Name of its observation.
    """
    widths = list(config.net_arch)
    return {
        "net_arch": {"pi": widths, "vf": list(widths)},
        "log_std_init": config.log_std_init,
        **policy_arguments(observation, adam_epsilon=1e-5, encoder=config.encoder),
    }
