"""Pure tasks in worker processes: submit, get results as they come, cancel, retry."""

from singulate.engine.interface import Batch, Engine, EngineError, TaskResult
from singulate.engine.local_engine import LocalEngine
from singulate.engine.opening import ENGINES, open_engine

__all__ = [
    "ENGINES",
    "Batch",
    "Engine",
    "EngineError",
    "LocalEngine",
    "TaskResult",
    "open_engine",
]
