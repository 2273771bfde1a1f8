"""What the page is derived from: one immutable picture of the whole laboratory."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from singulate.geometry import Poses, Push

FloatMap = npt.NDArray[np.float32]


@dataclass(frozen=True)
class PushReport:
    """One executed push, predicted against actual.

    Attributes:
        push: What was executed.
        by: Who pushed: ``agent``, or what others call a person.
        predicted: Reward that the loaded policy expected, where it can tell.
        reward: Actual total reward (Eq. 7).
        weighted_terms: Actual reward by term, weighted.
        is_success: Whether every pair of blocks is now apart.
        outcome: ``success``, ``empty``, ``inside``, ``off_table``, ``not_separated`` or
            ``simulation_error``.
        num_segments: Segments that the camera saw before and after.
        label_images: Segmentation before and after, int32 (H, W) each.
    """

    push: Push
    by: str
    predicted: float | None
    reward: float
    weighted_terms: Mapping[str, float]
    is_success: bool
    outcome: str
    num_segments: tuple[int, int]
    label_images: tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]


@dataclass(frozen=True)
class SceneSnapshot:
    """The live table.

    Attributes:
        version: Grows whenever the state at rest changes; fields carry the version they show.
        poses: Live block poses.
        pusher: Live pusher pose (x, y, z, yaw), None while it is lifted away.
        distance_map: Pixels, -1 inside, float32 (H, W), of the state at rest.
        rgb: Camera image, uint8 (H, W, 3), of the state at rest.
        motion_count: Simulation steps executed since the process started; tests and benchmarks
            measure click-to-motion with it.
        is_rearranged: Whether blocks were moved, added or removed by hand.
        held_block: The block that somebody moves by hand.
        held_by: Who moves it.
    """

    version: int
    scenario: str
    seed: int
    num_blocks: int
    poses: Poses
    pusher: tuple[float, float, float, float] | None
    is_pushing: bool
    is_paused: bool
    speed: float
    is_watching: bool
    can_undo: bool
    active_push: Push | None
    pushed_by: str
    distance_map: FloatMap
    mask: npt.NDArray[np.bool_]
    rgb: npt.NDArray[np.uint8]
    num_segments: int
    is_success: bool
    motion_count: int
    last_push: PushReport | None
    is_rearranged: bool = False
    held_block: int | None = None
    held_by: str = ""


@dataclass(frozen=True)
class RewardMapSnapshot:
    """True reward of every push: what has been computed of it so far.

    Attributes:
        values: float32 (4, H, W) in the order up, right, down, left.
        resolution: Cells along each side of `values`.
        progress: Share of the finest level that is done, 0 to 1.
        scene_version: The scene state that it belongs to.
    """

    values: FloatMap
    resolution: int
    progress: float
    scene_version: int


@dataclass(frozen=True)
class PolicySnapshot:
    """The loaded policy and what it believes about the scene at rest.

    Attributes:
        label: Name and step, for people.
        kind: Agent kind, such as ``dqn``.
        source: Checkpoint directory.
        num_steps: Training steps behind it.
        has_q_map: Whether this kind of agent has a value for every push.
        q_map: float32 (4, H, W), where it has one and somebody looks at it.
        start_density: float32 (H, W) summing to 1, where this kind has one.
        start_modes: Cells (row, column) at which it has a mode, the most prominent first.
        scene_version: The scene state that the fields belong to.
        is_live: Whether it follows the watched run's newest checkpoint.
    """

    label: str
    kind: str
    source: str
    num_steps: int
    has_q_map: bool
    q_map: FloatMap | None
    start_density: FloatMap | None
    start_modes: tuple[tuple[int, int], ...]
    scene_version: int
    is_live: bool


@dataclass(frozen=True)
class Curve:
    """One metric of a run: steps and values, float64 (N,) each."""

    steps: npt.NDArray[np.float64]
    values: npt.NDArray[np.float64]


@dataclass(frozen=True)
class RunSnapshot:
    """The watched training run.

    Attributes:
        state: ``starting``, ``running``, ``pausing``, ``paused``, ``stopping``, ``stopped``,
            ``finished``, ``failed`` or ``died``.
        reason: Why it failed or died, or what went wrong last without ending it; one line.
        age_s: Age of the trainer's last sign of life [s].
        curves: Metric histories by name.
        starts: Start positions of the pushes, float32 (N, 2) [m], in order of training.
        start_steps: Training step of each row of `starts`, int64 (N,).
        revision: Grows whenever `curves` or `starts` change.
    """

    run_dir: str
    name: str
    agent: str
    scenario: str
    state: str
    reason: str
    num_steps: int
    total_steps: int
    pushes_per_second: float
    eta_s: float | None
    age_s: float
    curves: Mapping[str, Curve]
    starts: FloatMap
    start_steps: npt.NDArray[np.int64]
    last_checkpoint: str
    revision: int


@dataclass(frozen=True)
class Notice:
    """Something that went wrong: what happened and what to do."""

    notice_id: int
    text: str
    is_error: bool = True


@dataclass(frozen=True)
class Snapshot:
    """Everything that the page shows, at one moment."""

    scene: SceneSnapshot | None
    reward_map: RewardMapSnapshot | None
    policy: PolicySnapshot | None
    run: RunSnapshot | None
    policies: tuple[tuple[str, str], ...] = ()
    """Policies that can be loaded: (label, source)."""
    runs: tuple[str, ...] = ()
    """Run directories that can be watched, newest first."""
    notices: tuple[Notice, ...] = field(default=())
