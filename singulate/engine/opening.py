"""Opening an engine by name."""

from importlib.util import find_spec

from singulate.engine.interface import Engine, EngineError
from singulate.engine.local_engine import LocalEngine
from singulate.exceptions import InvalidValueError

ENGINES = ("local", "ray")


def open_engine(
    name: str = "local",
    address: str | None = None,
    num_workers: int | None = None,
    *,
    niceness: int = 0,
    hang_timeout_s: float = 120.0,
) -> Engine:
    """Workers on this machine, or on a Ray cluster; Ray is imported for the latter only.

    Args:
        name: One of `ENGINES`.
        address: Of a Ray cluster; see `RayEngine`.
        num_workers: Workers; one a core by default.
        niceness: How far the workers stand back behind this process (0 to 19).
        hang_timeout_s: A worker that takes longer over one task is replaced, like a dead one.

    Raises:
        InvalidValueError: If a value is not allowed, or nothing listens at the address.
        EngineError: If Ray is not installed or refuses.
    """
    if name not in ENGINES:
        raise InvalidValueError("engine", name, ", ".join(ENGINES))
    if name == "local":
        if address is not None:
            raise InvalidValueError("address", address, "nothing beside the local engine")
        return LocalEngine(num_workers, niceness=niceness, hang_timeout_s=hang_timeout_s)
    if find_spec("ray") is None:
        raise EngineError("engine: ray is not installed; pip install 'singulate[ray]' brings it")
    from singulate.engine.ray_engine import RayEngine

    return RayEngine(address, num_workers, niceness=niceness, hang_timeout_s=hang_timeout_s)
