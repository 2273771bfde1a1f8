"""Settings of the spatial agent."""

from dataclasses import dataclass

from singulate.agents.config_fields import check_int, check_number, check_positive
from singulate.agents.net_arch import check_net_arch
from singulate.exceptions import InvalidValueError


@dataclass(frozen=True)
class SpatialConfig:
    """Found by trial on ``random-2`` and ``random-3``; nothing here is from the paper.

    Attributes:
        learning_rate: Step size of Adam at the first push.
        learning_rate_decay: Pushes after which it has fallen by sqrt(2); it falls as
            1 / sqrt(1 + pushes / this), so it depends on no total.
        net_arch: Channels of the trunk and of the head.
        average_decay: The weights that act are a running average of those that learn, which keeps
            this share of itself at each update.
        buffer_size: Pushes that are remembered; each takes up to 32 KiB of memory.
        learning_starts: Aimed random pushes before the first update.
        batch_size: Pushes an update.
        gradient_steps: Updates a push.
        best_share: Share of each batch that is drawn among the tenth of all pushes with the highest
            rewards, as in hybrid-pushing's stratified replay: successes are rare at first.
        huber_beta: Reward errors below this count squared, larger ones linearly [1000].
        exploration_steps: Pushes over which the exploration rate falls from 1 to its final value.
        exploration_final_eps: Exploration rate from then on.
        start_noise: Standard deviation of the starts of pushes that are not explored [m].
    """

    learning_rate: float = 2e-3
    learning_rate_decay: int = 1_000
    net_arch: tuple[int, ...] = (32, 64)
    average_decay: float = 0.98
    buffer_size: int = 20_000
    learning_starts: int = 50
    batch_size: int = 128
    gradient_steps: int = 2
    best_share: float = 0.25
    huber_beta: float = 0.3
    exploration_steps: int = 500
    exploration_final_eps: float = 0.05
    start_noise: float = 0.015

    def __post_init__(self) -> None:
        object.__setattr__(self, "net_arch", check_net_arch("net_arch", self.net_arch))
        if len(self.net_arch) != 2:
            raise InvalidValueError("net_arch", self.net_arch, "two widths: trunk and head")
        check_positive("learning_rate", self.learning_rate, 1.0)
        check_int("learning_rate_decay", self.learning_rate_decay, 1)
        check_number("average_decay", self.average_decay, 0.0, 1.0)
        check_int("buffer_size", self.buffer_size, 1, 1_000_000)
        check_int("learning_starts", self.learning_starts, 1)
        check_int("batch_size", self.batch_size, 1, 100_000)
        check_int("gradient_steps", self.gradient_steps, 1, 1000)
        check_number("best_share", self.best_share, 0.0, 1.0)
        check_positive("huber_beta", self.huber_beta, 100.0)
        check_int("exploration_steps", self.exploration_steps, 1)
        check_number("exploration_final_eps", self.exploration_final_eps, 0.0, 1.0)
        check_number("start_noise", self.start_noise, 0.0, 1.0)
