"""Settings of the DQN agent."""

from dataclasses import dataclass

from singulate.agents.config_fields import (
    check_bool,
    check_int,
    check_number,
    check_positive,
)
from singulate.agents.encoder_setting import check_encoder
from singulate.agents.net_arch import PAPER_NET_ARCH, check_net_arch
from singulate.exceptions import InvalidValueError


@dataclass(frozen=True)
class DQNConfig:
    """The paper gives the network (section 3.3) and the learning rate; the rest is ours.

    Attributes:
        learning_rate: Step size of Adam (Table 1), at the start.
        final_learning_rate: Step size after `anneal_steps` pushes, reached linearly; None to keep
            it as it is.
        anneal_steps: Pushes over which the step size falls; given with `final_learning_rate`.
        net_arch: Widths of the fully connected layers, ReLU after each (section 3.3). All values of
            a scene are linear in the last of them, of which the paper's has 16; wider last layers
            resolve more of the 400.
        buffer_size: Pushes that are remembered; each takes 32 KiB of memory.
        learning_starts: Random pushes before the first update.
        batch_size: Pushes an update.
        gradient_steps: Updates a push.
        gamma: Discount from one push to the next.
        target_update_interval: Pushes between updates of the target network, which does not affect
            what is learnt from one-push episodes.
        tau: How far each of them goes from the target network to the network. Below 1 the target
            network is a running average of the network (Polyak), and that is what acts once
            training is over: it does not shake with the last few updates.
        exploration_steps: Pushes over which the exploration rate falls from 1 to its final value.
        exploration_final_eps: Exploration rate from then on.
        exploration_aimed: Share of the explored pushes that start near an object and head for one;
            the others are uniform. Of uniform pushes on ``random-2``, 7 in 1,000 succeed.
        best_share: Share of each batch that is drawn among the tenth of all pushes with the highest
            rewards.
        symmetries: Replay each push turned and mirrored at random: the table looks and behaves the
            same in all eight symmetries of the square.
        symmetric_values: Act, once training is over, on the mean of the values that the network
            gives to the eight symmetric copies of a scene.
        encoder: Directory of an autoencoder whose code of the distance map is the agent's state;
            None for the map itself.
    """

    learning_rate: float = 5e-4
    net_arch: tuple[int, ...] = PAPER_NET_ARCH
    buffer_size: int = 10_000
    learning_starts: int = 500
    batch_size: int = 64
    gradient_steps: int = 2
    gamma: float = 0.9
    target_update_interval: int = 500
    tau: float = 1.0
    exploration_steps: int = 6_000
    exploration_final_eps: float = 0.05
    exploration_aimed: float = 0.0
    best_share: float = 0.0
    symmetries: bool = True
    symmetric_values: bool = False
    encoder: str | None = None
    final_learning_rate: float | None = None
    anneal_steps: int | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "net_arch", check_net_arch("net_arch", self.net_arch))
        check_positive("learning_rate", self.learning_rate, 1.0)
        check_int("buffer_size", self.buffer_size, 1, 1_000_000)
        check_int("learning_starts", self.learning_starts, 0)
        check_int("batch_size", self.batch_size, 1, 100_000)
        check_int("gradient_steps", self.gradient_steps, 1, 1000)
        check_number("gamma", self.gamma, 0.0, 1.0)
        check_int("target_update_interval", self.target_update_interval, 1)
        check_positive("tau", self.tau, 1.0)
        check_int("exploration_steps", self.exploration_steps, 1)
        check_number("exploration_final_eps", self.exploration_final_eps, 0.0, 1.0)
        check_number("exploration_aimed", self.exploration_aimed, 0.0, 1.0)
        check_number("best_share", self.best_share, 0.0, 1.0)
        check_bool("symmetries", self.symmetries)
        check_bool("symmetric_values", self.symmetric_values)
        check_encoder(self.encoder)
        self._check_annealing()

    def _check_annealing(self) -> None:
        pair = {
            "final_learning_rate": self.final_learning_rate,
            "anneal_steps": self.anneal_steps,
        }
        given, missing = sorted(pair, key=lambda name: pair[name] is None)
        if pair[given] is not None and pair[missing] is None:
            raise InvalidValueError(given, pair[given], f"together with {missing}")
        if self.final_learning_rate is not None:
            check_number("final_learning_rate", self.final_learning_rate, 0.0, 1.0)
            check_int("anneal_steps", self.anneal_steps, 1, 1_000_000_000)
