"""Seeds of single episodes, so that training, evaluation and data sets never share a scene."""

from typing import Literal

import numpy as np

from singulate.exceptions import InvalidValueError

Stream = Literal["training", "evaluation", "dataset"]
_OFFSETS: dict[str, int] = {"training": 0, "evaluation": 1, "dataset": 2**63}


def scene_seed(stream: Stream, run_seed: int, episode_index: int) -> int:
    """Seed of one episode of a run.

    Training seeds are even, evaluation seeds odd and those of data sets larger than either, so the
    three sets are disjoint by construction.

    Args:
        stream: What the episode is for.
        run_seed: Seed of the whole run, at least 0.
        episode_index: Number of the episode in the run, from 0.

    Returns:
        A seed for `Env.reset`, 0 to 2**63 - 1, and for data sets up to 2**64 - 1.

    Raises:
        InvalidValueError: If the seed or the index is negative, or the stream is unknown.
    """
    if stream not in _OFFSETS:
        raise InvalidValueError("stream", stream, ", ".join(_OFFSETS))
    for key, value in (("seed", run_seed), ("episode_index", episode_index)):
        if value < 0:
            raise InvalidValueError(key, value, "an integer of at least 0")
    state = np.random.SeedSequence([run_seed, episode_index]).generate_state(1, np.uint64)
    return (int(state[0]) >> 2) * 2 + _OFFSETS[stream]
