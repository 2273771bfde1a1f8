"""Workers on a Ray cluster."""

from singulate.engine.dispatched_engine import MAX_WORKERS, DispatchedEngine, check_workers
from singulate.engine.ray_connection import connect, count_cores, disconnect


class RayEngine(DispatchedEngine):
    """An `Engine` of Ray actors, each on one core of a cluster.

    Every node needs this package, at the same version, in the interpreter that Ray runs there. An
    actor that dies, with or without its node, is replaced on any node that has a core to spare.

    Args:
        address: See `connect`; None starts Ray on this machine and ends it with the engine.
        num_workers: Actors; one a core of the cluster by default.
        niceness: How far the workers stand back behind Ray on their nodes (0 to 19).
        hang_timeout_s: A worker that takes longer over one task is replaced, like a dead one.
        cancel_grace_s: A worker that is still busy with a cancelled task after this is replaced.

    Raises:
        InvalidValueError: If a value is out of range or nothing listens at the address.
        EngineError: If Ray refuses.
    """

    def __init__(
        self,
        address: str | None = None,
        num_workers: int | None = None,
        *,
        niceness: int = 0,
        hang_timeout_s: float = 120.0,
        cancel_grace_s: float = 10.0,
    ) -> None:
        check_workers(1 if num_workers is None else num_workers, niceness)
        self._has_connected = connect(address, num_workers)
        from singulate.engine.ray_dispatcher import RayDispatcher  # Ray is imported by `connect`

        if num_workers is None:
            num_workers = min(max(count_cores(), 1), MAX_WORKERS)
        dispatcher = RayDispatcher(num_workers, niceness, hang_timeout_s, cancel_grace_s)
        super().__init__(num_workers, dispatcher)

    def close(self) -> None:
        """Cancel everything and end the workers; may be called twice."""
        super().close()
        if self._has_connected:
            self._has_connected = False
            disconnect()
