"""The same seed and actions give the same bits, in any process."""

import json
import subprocess
import sys

import pytest

EPISODES = 200

PROGRAM = """
import hashlib, json, sys
import gymnasium, numpy as np, singulate

scenario, warm_up, num_episodes, nudge = sys.argv[1], *map(float, sys.argv[2:])
env = gymnasium.make("singulate/Push-v0", scenario=scenario, action="point")
for _ in range(int(warm_up)):
    env.reset(seed=999)
    env.step(env.action_space.sample())
digest = hashlib.sha256()
touching = 0
env.action_space.seed(7)
for episode in range(int(num_episodes)):
    observation, info = env.reset(seed=episode)
    over = False
    while not over:
        digest.update(observation.tobytes() + info["mask"].tobytes())
        digest.update(repr((info["num_segments"], info["inter_object_distance"])).encode())
        action = env.action_space.sample()
        if episode % 2:
            x, y, _ = info["poses"][0].position
            action = np.array([x + nudge, min(max(y - 0.3, -1), 1), -0.9], dtype=np.float32)
        observation, reward, terminated, truncated, info = env.step(action)
        touching += info["outcome"].is_touching
        digest.update(repr((reward, terminated, truncated, info["reward_terms"])).encode())
        digest.update(repr((info["is_success"], info["poses"])).encode())
        over = terminated or truncated
    digest.update(observation.tobytes())
print(json.dumps({"digest": digest.hexdigest(), "touching": touching}))
"""


def run(
    scenario: str, warm_up: int = 0, num_episodes: int = EPISODES, nudge_m: float = 0.0
) -> dict:
    arguments = map(str, (scenario, warm_up, num_episodes, nudge_m))
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, *arguments], capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout.splitlines()[-1])


@pytest.mark.parametrize("scenario", ["random-3", "cluster-3"])
def test_two_processes_agree_over_200_episodes_whatever_they_did_before(scenario):
    fresh, experienced = run(scenario), run(scenario, warm_up=5)
    assert fresh == experienced
    assert fresh["touching"] > EPISODES / 3


def test_the_digest_notices_a_push_that_is_moved_by_a_micrometre():
    plain, nudged = run("random-3", num_episodes=4), run("random-3", num_episodes=4, nudge_m=1e-6)
    assert plain["touching"] == nudged["touching"] > 0
    assert plain["digest"] != nudged["digest"]
