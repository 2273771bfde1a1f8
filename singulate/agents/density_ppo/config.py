"""Settings that all PPO agents with a density of their own share."""

from dataclasses import dataclass

from singulate.agents.config_fields import check_int, check_number, check_positive
from singulate.agents.net_arch import check_net_arch
from singulate.exceptions import InvalidValueError


@dataclass(frozen=True)
class DensityPPOConfig:
    """Found by trial of ``multimodal-ppo`` on ``random-2``, from the usual values of PPO on.

    Steps are bold at first, because only about one push in a hundred succeeds and the clip bounds
    how much likelier an update can make it: small rollouts, a wide clip and a large step size
    multiply it sooner. What is then too coarse, the falling step size refines.

    Attributes:
        learning_rate: Step size of Adam at the start.
        final_learning_rate: Step size after `anneal_steps` pushes, reached linearly.
        anneal_steps: Pushes over which step size and entropy bonus fall.
        n_steps: Pushes between updates, of all environments together.
        n_epochs: Passes over them.
        batch_size: Pushes a mini-batch.
        net_arch: Channels of the convolutions, ReLU after each.
        gamma: Discount from one push to the next.
        gae_lambda: Trade-off of bias and variance in the advantage.
        clip_range: Epsilon of the clipped objective.
        ent_coef: Weight of the entropy bonus at the start.
        final_ent_coef: Weight after `anneal_steps` pushes, reached linearly.
        vf_coef: Weight of the value's loss.
        max_grad_norm: Gradients are shortened to this length.
    """

    learning_rate: float = 4e-3
    final_learning_rate: float = 2e-4
    anneal_steps: int = 20_000
    n_steps: int = 256
    n_epochs: int = 4
    batch_size: int = 64
    net_arch: tuple[int, ...] = (16, 16, 16, 16)
    gamma: float = 0.99
    gae_lambda: float = 0.95
    clip_range: float = 0.4
    ent_coef: float = 0.03
    final_ent_coef: float = 0.003
    vf_coef: float = 0.5
    max_grad_norm: float = 0.5

    def __post_init__(self) -> None:
        object.__setattr__(self, "net_arch", check_net_arch("net_arch", self.net_arch))
        check_positive("learning_rate", self.learning_rate, 1.0)
        check_number("final_learning_rate", self.final_learning_rate, 0.0, 1.0)
        check_int("anneal_steps", self.anneal_steps, 1, 1_000_000_000)
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
        check_number("final_ent_coef", self.final_ent_coef, 0.0, 10.0)
        check_number("vf_coef", self.vf_coef, 0.0, 100.0)
        check_positive("max_grad_norm", self.max_grad_norm, 1000.0)
