"""The live table as the page sees it."""

from app.processes.scene_messages import LiveState, RestState
from app.snapshot import PushReport, SceneSnapshot


class SceneView:
    """Puts scene snapshots together; the same parts give the very same snapshot."""

    def __init__(self) -> None:
        self._parts: tuple[object, ...] = ()
        self._snapshot: SceneSnapshot | None = None

    def snapshot(
        self,
        live: LiveState | None,
        rest: RestState | None,
        last_push: PushReport | None,
        is_watching: bool,
    ) -> SceneSnapshot | None:
        """The scene, or None as long as nothing has been heard of it."""
        if live is None or rest is None:
            return None
        parts = (live, rest, last_push, is_watching)
        if self._snapshot is None or not _are_same(parts, self._parts):
            self._parts = parts
            self._snapshot = _compose(live, rest, last_push, is_watching)
        return self._snapshot


def _are_same(a: tuple[object, ...], b: tuple[object, ...]) -> bool:
    return len(a) == len(b) and all(x is y for x, y in zip(a, b, strict=True))


def _compose(
    live: LiveState, rest: RestState, last_push: PushReport | None, is_watching: bool
) -> SceneSnapshot:
    return SceneSnapshot(
        version=rest.version,
        scenario=rest.scene.scenario,
        seed=rest.scene.seed,
        num_blocks=rest.scene.num_blocks,
        poses=live.poses,
        pusher=live.pusher,
        is_pushing=live.active_push is not None,
        is_paused=live.is_paused,
        speed=live.speed,
        is_watching=is_watching,
        can_undo=bool(rest.history) or live.active_push is not None,
        active_push=live.active_push,
        pushed_by=live.pushed_by,
        distance_map=rest.percept.distance_map,
        mask=rest.percept.mask,
        rgb=rest.rgb,
        num_segments=rest.percept.num_segments,
        is_success=rest.is_success,
        motion_count=live.motion_count,
        last_push=last_push,
        is_rearranged=rest.scene.is_rearranged,
        held_block=live.held_block,
        held_by=live.held_by,
    )
