"""Settings of the SAC agent."""

from dataclasses import dataclass

from singulate.agents.config_fields import check_int, check_number, check_positive
from singulate.agents.net_arch import PAPER_NET_ARCH, check_net_arch


@dataclass(frozen=True)
class SACConfig:
    """The paper has no SAC: network and learning rate are those that it gives, the rest is ours.

    Attributes:
        learning_rate: Step size of Adam (Table 1).
        net_arch: Widths of the fully connected layers, ReLU after each (section 3.3), of the actor
            and of both critics, which share the first: the action comes in behind it.
        buffer_size: Pushes that are remembered; each takes 32 KiB of memory.
        learning_starts: Uniformly random pushes before the first update.
        batch_size: Pushes an update.
        gradient_steps: Updates a push.
        gamma: Discount from one push to the next.
        tau: Share of the critics that an update mixes into their targets.
        initial_ent_coef: Weight of the entropy at the start, against a reward of 1 for success;
            learnt from then on.
        target_entropy: What the entropy of a push is driven to, per dimension of the action [nats]
            (Haarnoja et al. 2018, appendix D: -1).
    """

    learning_rate: float = 5e-4
    net_arch: tuple[int, ...] = PAPER_NET_ARCH
    buffer_size: int = 10_000
    learning_starts: int = 500
    batch_size: int = 64
    gradient_steps: int = 1
    gamma: float = 0.9
    tau: float = 0.005
    initial_ent_coef: float = 0.1
    target_entropy: float = -1.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "net_arch", check_net_arch("net_arch", self.net_arch))
        check_positive("learning_rate", self.learning_rate, 1.0)
        check_int("buffer_size", self.buffer_size, 1, 1_000_000)
        check_int("learning_starts", self.learning_starts, 1)
        check_int("batch_size", self.batch_size, 1, 100_000)
        check_int("gradient_steps", self.gradient_steps, 1, 1000)
        check_number("gamma", self.gamma, 0.0, 1.0)
        check_positive("tau", self.tau, 1.0)
        check_positive("initial_ent_coef", self.initial_ent_coef, 100.0)
        check_number("target_entropy", self.target_entropy, -10.0, 1.0)
