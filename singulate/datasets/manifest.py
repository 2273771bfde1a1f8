"""What a data set says about itself: ``dataset.json``."""

import hashlib
import json
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from singulate.checkpoints.durable import replace_file
from singulate.exceptions import InvalidValueError, SingulateError
from singulate.rewardmap import RewardMapRequest
from singulate.rewards import make_reward
from singulate.simulation import make_scenario

MANIFEST_NAME = "dataset.json"
FORMAT = "singulate-reward-maps"
FORMAT_VERSION = 1
MAX_SCENES = 100_000_000
MAX_SHARD_SIZE = 4096


class DatasetError(SingulateError):
    """A data set is missing, damaged or not one of ours."""


@dataclass(frozen=True)
class DatasetConfig:
    """What decides the content of a data set, bit for bit.

    Attributes:
        scenario: Where its scenes are from.
        num_scenes: How many there are.
        seed: Decides the scenes; they are disjoint from those of training and evaluation.
        resolution: Starts along each side of a map.
        reward: Name of the reward; it may not follow a schedule.
        goal_separation: d_goal of Eq. 2 [m].
        shard_size: Scenes of a shard.

    Raises:
        InvalidValueError: If a value is not allowed.
    """

    scenario: str = "random-2"
    num_scenes: int = 1000
    seed: int = 0
    resolution: int = 64
    reward: str = "paper"
    goal_separation: float = 0.1
    shard_size: int = 128

    def __post_init__(self) -> None:
        make_scenario(self.scenario)
        RewardMapRequest((), self.resolution, self.goal_separation, self.reward)
        if make_reward(self.reward).num_warmup_pushes:
            raise InvalidValueError("reward", self.reward, "a reward without a schedule")
        limits = {
            "num_scenes": (1, MAX_SCENES),
            "seed": (0, 2**63 - 1),
            "shard_size": (1, MAX_SHARD_SIZE),
        }
        for key, (low, high) in limits.items():
            if not low <= getattr(self, key) <= high:
                raise InvalidValueError(key, getattr(self, key), f"{low} to {high}")

    @property
    def num_shards(self) -> int:
        """How many files hold the scenes."""
        return -(-self.num_scenes // self.shard_size)

    def scenes_of(self, shard: int) -> range:
        """Indices of the scenes of a shard."""
        first = shard * self.shard_size
        return range(first, min(first + self.shard_size, self.num_scenes))


@dataclass(frozen=True)
class ShardEntry:
    """Scenes, size [bytes] and SHA-256 of one shard."""

    num_scenes: int
    size: int
    sha256: str

    @classmethod
    def of(cls, num_scenes: int, data: bytes) -> "ShardEntry":
        """Entry for a shard with this content."""
        return cls(num_scenes, len(data), hashlib.sha256(data).hexdigest())


@dataclass(frozen=True)
class Manifest:
    """A data set's description.

    Attributes:
        config: What it holds, or shall hold.
        shards: The shards that are there, by number.
    """

    config: DatasetConfig
    shards: dict[int, ShardEntry] = field(default_factory=dict)

    @property
    def is_complete(self) -> bool:
        """Whether every scene is there."""
        return sum(entry.num_scenes for entry in self.shards.values()) == self.config.num_scenes

    @property
    def sha256(self) -> str:
        """Hash of the content: equal data sets have equal ones, wherever they were built."""
        hashes = [self.shards[number].sha256 for number in sorted(self.shards)]
        content = json.dumps([asdict(self.config), hashes], sort_keys=True)
        return hashlib.sha256(content.encode()).hexdigest()

    def write(self, directory: Path) -> None:
        """Put it into the data set's directory, as a whole or not at all.

        Raises:
            OSError: If it cannot be written.
        """
        content = {
            "format": FORMAT,
            "format_version": FORMAT_VERSION,
            "config": asdict(self.config),
            "sha256": self.sha256,
            "shards": {shard_name(n): asdict(self.shards[n]) for n in sorted(self.shards)},
        }
        replace_file(directory / MANIFEST_NAME, (json.dumps(content, indent=1) + "\n").encode())


def shard_name(number: int) -> str:
    """File name of a shard.

    >>> shard_name(3)
    'shard-000003.npz'
    """
    return f"shard-{number:06d}.npz"


def read_manifest(directory: Path) -> Manifest:
    """Read what `Manifest.write` wrote.

    Raises:
        DatasetError: If there is none, or it is damaged.
    """
    path = directory / MANIFEST_NAME
    try:
        content: dict[str, Any] = json.loads(path.read_bytes())
        if content["format"] != FORMAT or content["format_version"] != FORMAT_VERSION:
            raise DatasetError(f"{path}: of another format; allowed: version {FORMAT_VERSION}")
        config = DatasetConfig(**content["config"])
        shards = {
            number: ShardEntry(**content["shards"][shard_name(number)])
            for number in range(config.num_shards)
            if shard_name(number) in content["shards"]
        }
        manifest = Manifest(config, shards)
        if manifest.sha256 != content["sha256"]:
            raise ValueError("its own hash does not fit")
    except FileNotFoundError:
        raise DatasetError(
            f"{directory}: holds no data set ({MANIFEST_NAME}); make one with singulate dataset"
        ) from None
    except OSError as error:
        raise DatasetError(f"{path}: {error.strerror or error}") from None
    except KeyError as error:
        raise DatasetError(f"{path}: damaged ({error.args[0]} is missing)") from None
    except TypeError:
        raise DatasetError(f"{path}: damaged (a value of another type is expected)") from None
    except ValueError as error:
        raise DatasetError(f"{path}: damaged ({error})") from None
    return manifest
