"""Pure tasks in worker processes: submit, get results as they come, cancel, retry."""

from singulate.engine.interface import Batch, Engine, EngineError, TaskResult
from singulate.engine.local_engine import LocalEngine

__all__ = ["Batch", "Engine", "EngineError", "LocalEngine", "TaskResult"]
