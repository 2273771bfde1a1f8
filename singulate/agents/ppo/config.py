"""Settings of the PPO agent."""

from dataclasses import dataclass

from singulate.agents.config_fields import check_int, check_number, check_positive
from singulate.agents.encoder_setting import check_encoder
from singulate.agents.net_arch import PAPER_NET_ARCH, check_net_arch
from singulate.exceptions import InvalidValueError


@dataclass(frozen=True)
class PPOConfig:
    """Table 1 of the paper, taken literally; stable-baselines3's defaults otherwise.

    Attributes:
        learning_rate: Step size of Adam (Table 1).
        n_steps: Pushes between updates, of all environments together; "batch size" in Table 1.
        n_epochs: Passes over them (Table 1).
        batch_size: Pushes a mini-batch (Table 1).
        net_arch: Widths of the fully connected layers, ReLU after each (section 3.3); policy and
            value have one such network each.
        gamma: Discount from one push to the next.
        gae_lambda: Trade-off of bias and variance in the advantage.
        clip_range: Epsilon of the clipped objective (section 2).
        ent_coef: Weight of the entropy bonus.
        log_std_init: Logarithm of the Gaussian's standard deviation at the start.
        encoder: Directory of an autoencoder whose code of the distance map is the agent's state;
            None for the map itself.
    """

    learning_rate: float = 5e-4
    n_steps: int = 2048
    n_epochs: int = 3
    batch_size: int = 4
    net_arch: tuple[int, ...] = PAPER_NET_ARCH
    gamma: float = 0.99
    gae_lambda: float = 0.95
    clip_range: float = 0.2
    ent_coef: float = 0.0
    log_std_init: float = 0.0
    encoder: str | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "net_arch", check_net_arch("net_arch", self.net_arch))
        check_positive("learning_rate", self.learning_rate, 1.0)
        check_int("n_steps", self.n_steps, 2, 1_000_000)
        check_int("n_epochs", self.n_epochs, 1, 1000)
        check_int("batch_size", self.batch_size, 2, 100_000)
        if self.batch_size > self.n_steps:
            raise InvalidValueError(
                "batch_size", self.batch_size, f"at most n_steps ({self.n_steps})"
            )
        check_number("gamma", self.gamma, 0.0, 1.0)
        check_number("gae_lambda", self.gae_lambda, 0.0, 1.0)
        check_positive("clip_range", self.clip_range, 1.0)
        check_number("ent_coef", self.ent_coef, 0.0, 10.0)
        check_number("log_std_init", self.log_std_init, -5.0, 5.0)
        check_encoder(self.encoder)
