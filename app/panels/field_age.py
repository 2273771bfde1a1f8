"""How old the fields are, how fine, and whose belief they show."""

from app.snapshot import PolicySnapshot, RewardMapSnapshot, Snapshot


def reward_map_line(snapshot: Snapshot) -> str:
    """Resolution and progress of the true reward."""
    truth = snapshot.reward_map
    if truth is None:
        return "not computed yet"
    size = f"{truth.resolution} \N{MULTIPLICATION SIGN} {truth.resolution}"
    progress = "" if truth.progress >= 1.0 else f" · {100.0 * truth.progress:.0f} % done"
    return size + progress + _staleness(snapshot, truth)


def policy_line(snapshot: Snapshot) -> str:
    """Which checkpoint the agent's fields show."""
    policy = snapshot.policy
    if policy is None:
        return "no agent loaded"
    live = " · follows the run" if policy.is_live else ""
    steps = "" if f"{policy.num_steps:,}" in policy.label else f" after {policy.num_steps:,} pushes"
    return f"{policy.label}{steps}{live}" + _staleness(snapshot, policy)


def _staleness(snapshot: Snapshot, source: RewardMapSnapshot | PolicySnapshot) -> str:
    if snapshot.scene is None or source.scene_version == snapshot.scene.version:
        return ""
    return " · of an earlier table"
