"""How good a policy is: many unseen scenes, the same ones for every policy."""

from singulate.evaluation.evaluate import evaluate
from singulate.evaluation.evaluation import Evaluation, summarise
from singulate.evaluation.evaluator import EpisodeResult, Evaluator
from singulate.evaluation.wilson import wilson_interval

__all__ = [
    "EpisodeResult",
    "Evaluation",
    "Evaluator",
    "evaluate",
    "summarise",
    "wilson_interval",
]
