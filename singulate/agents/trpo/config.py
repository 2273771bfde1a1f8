"""Settings of the TRPO agent."""

from dataclasses import dataclass

from singulate.agents.config_fields import check_int, check_number, check_positive
from singulate.agents.encoder_setting import check_encoder
from singulate.agents.net_arch import PAPER_NET_ARCH, check_net_arch
from singulate.exceptions import InvalidValueError


@dataclass(frozen=True)
class TRPOConfig:
    """What PPO has in Table 1, as far as TRPO has it too; sb3-contrib's defaults otherwise.

    So the two differ in nothing but how a rollout changes the policy.

    Attributes:
        learning_rate: Step size of Adam (Table 1); only the critic is learnt by it.
        n_steps: Pushes between updates, of all environments together; "batch size" in Table 1.
        batch_size: Pushes a mini-batch of the critic; the policy is updated on all pushes at once.
        n_critic_updates: The critic's passes over them.
        net_arch: Widths of the fully connected layers, ReLU after each (section 3.3); policy and
            value have one such network each.
        gamma: Discount from one push to the next.
        gae_lambda: Trade-off of bias and variance in the advantage.
        target_kl: Size of the trust region: the mean Kullback-Leibler divergence that an update
            may bring [nats] (Schulman et al. 2015, section 6).
        cg_max_steps: Steps of the conjugate gradient method that finds the update's direction.
        cg_damping: What is added to the diagonal of the Fisher matrix there.
        log_std_init: Logarithm of the Gaussian's standard deviation at the start.
        encoder: Directory of an autoencoder whose code of the distance map is the agent's state;
            None for the map itself.
    """

    learning_rate: float = 5e-4
    n_steps: int = 2048
    batch_size: int = 128
    n_critic_updates: int = 10
    net_arch: tuple[int, ...] = PAPER_NET_ARCH
    gamma: float = 0.99
    gae_lambda: float = 0.95
    target_kl: float = 0.01
    cg_max_steps: int = 15
    cg_damping: float = 0.1
    log_std_init: float = 0.0
    encoder: str | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "net_arch", check_net_arch("net_arch", self.net_arch))
        check_positive("learning_rate", self.learning_rate, 1.0)
        check_int("n_steps", self.n_steps, 2, 1_000_000)
        check_int("batch_size", self.batch_size, 1, 100_000)
        if self.batch_size > self.n_steps:
            raise InvalidValueError(
                "batch_size", self.batch_size, f"at most n_steps ({self.n_steps})"
            )
        check_int("n_critic_updates", self.n_critic_updates, 1, 1000)
        check_number("gamma", self.gamma, 0.0, 1.0)
        check_number("gae_lambda", self.gae_lambda, 0.0, 1.0)
        check_positive("target_kl", self.target_kl, 10.0)
        check_int("cg_max_steps", self.cg_max_steps, 1, 1000)
        check_positive("cg_damping", self.cg_damping, 10.0)
        check_number("log_std_init", self.log_std_init, -5.0, 5.0)
        check_encoder(self.encoder)
