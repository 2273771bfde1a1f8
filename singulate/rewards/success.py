"""r_Success: pays once the objects are singulated (paper, Eq. 6)."""

from singulate.perception import Segmentation


def is_success(after: Segmentation, num_blocks: int, goal: float) -> bool:
    """Whether the picture shows every block on its own, far enough from all others.

    The same as Eq. 6 with d_IOgoal = C(N, 2) d_goal for the truncated distance: with N segments,
    d_IOT reaches C(N, 2) d_goal exactly where each of its C(N, 2) summands reaches d_goal.

    Args:
        after: The scene after the push.
        num_blocks: N, how many blocks the scene holds.
        goal: d_goal, the separation that is enough, edge to edge [m].

    Returns:
        True if the picture shows `num_blocks` segments and each separation is at least `goal`.
    """
    return after.num_segments == num_blocks and all(
        separation >= goal for separation in after.separations.tolist()
    )


def success_reward(is_success: bool) -> float:
    """1 where the objects are singulated, otherwise 0."""
    return 1.0 if is_success else 0.0
