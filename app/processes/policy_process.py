"""The policy process: loads checkpoints and answers what the policy believes, when asked."""

import numpy as np
import torch

from app.policy_label import policy_label
from app.processes.pipes import Pipe
from app.processes.policy_messages import (
    ChoosePush,
    ChosenPush,
    ComputeFields,
    Fields,
    Load,
    Loaded,
    NotLoaded,
    PolicyProblem,
    Prediction,
    PredictReward,
)
from singulate.agents.density_modes import Mode, density_modes
from singulate.agents.loading import checkpoint_directory, policy_from_checkpoint
from singulate.agents.policy import FloatMap, HasQMap, HasStartDensity, Policy
from singulate.checkpoints import read_checkpoint
from singulate.envs import Observation, make_observation
from singulate.exceptions import SingulateError
from singulate.geometry import Workspace
from singulate.perception import Percept


def run_policy(connection: Pipe) -> None:
    """Serve policies until the pipe is closed.

    Args:
        connection: Pipe to the laboratory; see `policy_messages`.
    """
    torch.set_num_threads(1)
    answerer = PolicyAnswerer()
    while True:
        connection.send(answerer.answer(connection.recv()))


class PolicyAnswerer:
    """One loaded policy and the questions that it answers."""

    def __init__(self) -> None:
        self._source = ""
        self._policy: Policy | None = None
        self._observation: Observation | None = None
        self._rng = np.random.default_rng(0)

    def answer(self, question: object) -> object:
        """Answer one message; every question has an answer, for somebody waits for it."""
        if isinstance(question, Load):
            return self._load(question.source)
        if self._policy is None:
            return PolicyProblem("No policy is loaded; choose one, or train one.")
        try:
            return self._ask(self._policy, question)
        except SingulateError as error:
            return PolicyProblem(str(error))

    def _load(self, source: str) -> Loaded | NotLoaded:
        try:
            directory = checkpoint_directory(source)
            checkpoint = read_checkpoint(directory, with_files=False)
            policy = policy_from_checkpoint(checkpoint)
        except SingulateError as error:
            return NotLoaded(source, str(error), has_other=self._policy is not None)
        self._policy = policy
        self._observation = make_observation(policy.observation, Workspace())
        self._source = source
        step = checkpoint.manifest.step
        label, has_q_map = policy_label(directory, step), isinstance(policy, HasQMap)
        return Loaded(source, label, policy.kind, step, has_q_map)

    def _ask(self, policy: Policy, question: object) -> object:
        match question:
            case ComputeFields(version, percept, wants_q_map, wants_start_density):
                seen = self._observe(percept)
                q_map = density = None
                modes: list[Mode] = []
                if wants_q_map and isinstance(policy, HasQMap):
                    q_map = policy.q_map(seen)
                if wants_start_density and isinstance(policy, HasStartDensity):
                    density = policy.start_density(seen)
                    modes = density_modes(density)
                cells = tuple((mode.row, mode.col) for mode in modes)
                return Fields(self._source, version, q_map, density, cells)
            case ChoosePush(version, percept):
                rng = self._rng if policy.is_random else None
                return ChosenPush(version, policy.act(self._observe(percept), rng))
            case PredictReward(push_id, percept, push):
                return Prediction(push_id, policy.predict_value(self._observe(percept), push))
        return PolicyProblem(f"{type(question).__name__} is no question to a policy.")

    def _observe(self, percept: Percept) -> FloatMap:
        assert self._observation is not None
        return self._observation.observe(percept)
