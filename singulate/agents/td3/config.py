"""Settings of the TD3 agent."""

from dataclasses import dataclass

from singulate.agents.config_fields import check_int, check_number, check_positive
from singulate.agents.net_arch import PAPER_NET_ARCH, check_net_arch


@dataclass(frozen=True)
class TD3Config:
    """The paper has no TD3: network and learning rate are those that it gives, the rest is ours.

    Attributes:
        learning_rate: Step size of Adam (Table 1).
        net_arch: Widths of the fully connected layers, ReLU after each (section 3.3), of the actor
            and of both critics, which share the first: the action comes in behind it.
        buffer_size: Pushes that are remembered; each takes 32 KiB of memory.
        learning_starts: Uniformly random pushes before the first update.
        batch_size: Pushes an update.
        gradient_steps: Updates of the critics a push.
        gamma: Discount from one push to the next.
        tau: Share of actor and critics that an update mixes into their targets.
        policy_delay: Updates of the critics for each of the actor (Fujimoto et al. 2018).
        target_policy_noise: Standard deviation of what is added to the targets' actions (ibid.).
        target_noise_clip: Limit of that (ibid.).
        exploration_noise: Standard deviation of what is added to the actions tried, of which each
            dimension is 2 wide.
    """

    learning_rate: float = 5e-4
    net_arch: tuple[int, ...] = PAPER_NET_ARCH
    buffer_size: int = 10_000
    learning_starts: int = 500
    batch_size: int = 64
    gradient_steps: int = 1
    gamma: float = 0.9
    tau: float = 0.005
    policy_delay: int = 2
    target_policy_noise: float = 0.2
    target_noise_clip: float = 0.5
    exploration_noise: float = 0.1

    def __post_init__(self) -> None:
        object.__setattr__(self, "net_arch", check_net_arch("net_arch", self.net_arch))
        check_positive("learning_rate", self.learning_rate, 1.0)
        check_int("buffer_size", self.buffer_size, 1, 1_000_000)
        check_int("learning_starts", self.learning_starts, 1)
        check_int("batch_size", self.batch_size, 1, 100_000)
        check_int("gradient_steps", self.gradient_steps, 1, 1000)
        check_number("gamma", self.gamma, 0.0, 1.0)
        check_positive("tau", self.tau, 1.0)
        check_int("policy_delay", self.policy_delay, 1, 1000)
        check_number("target_policy_noise", self.target_policy_noise, 0.0, 2.0)
        check_number("target_noise_clip", self.target_noise_clip, 0.0, 2.0)
        check_number("exploration_noise", self.exploration_noise, 0.0, 2.0)
