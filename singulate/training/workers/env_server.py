"""The environments that live in one worker."""

from typing import Any

from singulate.agents.reward_scale import ScaledReward
from singulate.envs.push_env import PushEnv
from singulate.training.seeded_episodes import SeededEpisodes
from singulate.training.workers.messages import Act, Acted, Request, Restore, Restored, Settings


class EnvServer:
    """Answers requests to environments, each made when it is first restored.

    Args:
        settings: What they are like.
    """

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._episodes: dict[int, SeededEpisodes] = {}

    def answer(self, request: Request) -> Restored | Acted:
        """Do what is asked."""
        if isinstance(request, Restore):
            return self._restore(request)
        return self._act(request)

    def _restore(self, request: Restore) -> Restored:
        if request.env_index not in self._episodes:
            env = PushEnv(None, **self._settings.env.to_dict())
            self._episodes[request.env_index] = SeededEpisodes(env, self._settings.run_seed)
        episodes = self._episodes[request.env_index]
        return Restored(request.env_index, episodes.restore(request.state))

    def _act(self, request: Act) -> Acted:
        episodes = self._episodes[request.env_index]
        if request.loss:
            episodes.lose_next_push(request.loss)
        outcome = ScaledReward(episodes).step(request.action)
        observation, reward, terminated, truncated, step_info = outcome
        info: dict[str, Any] = {**step_info, "TimeLimit.truncated": truncated and not terminated}
        is_done = terminated or truncated
        if is_done:
            info["terminal_observation"] = observation
            observation, _ = episodes.reset()
        return Acted(request.env_index, observation, reward, is_done, info)
