"""The reward: a weighted sum of terms (paper, Eq. 7)."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from singulate.exceptions import InvalidValueError
from singulate.rewards.terms import TERMS


@dataclass(frozen=True)
class RewardFunction:
    """A weighted sum of terms, optionally with other weights for the first pushes of a run.

    Attributes:
        name: What users call it.
        weights: Weight of each term; a term that is left out has weight 0.
        num_warmup_pushes: For how many pushes of the run `warmup_weights` hold instead.
        warmup_weights: Weight of each term during these.

    Raises:
        InvalidValueError: If a weight belongs to no term, or `num_warmup_pushes` is negative.

    Example:
        >>> reward = RewardFunction("example", {"distance": 1000.0, "inside": -100.0})
        >>> terms = {"start": 1.0, "distance": 0.125, "inside": 1.0, "success": 0.0}
        >>> reward.weighted(terms)
        {'start': 0.0, 'distance': 125.0, 'inside': -100.0, 'success': 0.0}
        >>> reward.total(terms)
        25.0
    """

    name: str
    weights: Mapping[str, float]
    num_warmup_pushes: int = 0
    warmup_weights: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        unknown = (set(self.weights) | set(self.warmup_weights)) - set(TERMS)
        if unknown:
            raise InvalidValueError("reward.weights", min(unknown), ", ".join(TERMS))
        if self.num_warmup_pushes < 0:
            raise InvalidValueError("reward.num_warmup_pushes", self.num_warmup_pushes, ">= 0")

    def weights_at(self, num_pushes: int) -> Mapping[str, float]:
        """Weights for a push before which the run has made `num_pushes` others."""
        return self.warmup_weights if num_pushes < self.num_warmup_pushes else self.weights

    def weighted(self, terms: Mapping[str, float], num_pushes: int = 0) -> dict[str, float]:
        """Share of each term in the reward.

        Args:
            terms: Unweighted value of every term in `TERMS`.
            num_pushes: How many pushes the run made before this one.

        Returns:
            Weight times value, by term, in the order of `TERMS`.
        """
        weights = self.weights_at(num_pushes)
        return {term: weights[term] * terms[term] if term in weights else 0.0 for term in TERMS}

    def total(self, terms: Mapping[str, float], num_pushes: int = 0) -> float:
        """The reward r_t of one push (paper, Eq. 7).

        Args:
            terms: Unweighted value of every term in `TERMS`.
            num_pushes: How many pushes the run made before this one.
        """
        return sum(self.weighted(terms, num_pushes).values())
