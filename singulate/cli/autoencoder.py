"""``singulate autoencoder``: a small code of the distance map, as a state for agents."""

import argparse
import json
import time
from pathlib import Path
from typing import TYPE_CHECKING

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.config_fields import check_int
from singulate.cli.progress import StepBars
from singulate.cli.targets import check_checkpoint_target

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DEFAULTS = AutoencoderConfig()


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "learn a small code of the distance map, as a state for agents"
    parser = subparsers.add_parser("autoencoder", help=text, description=text)
    parser.add_argument(
        "--scenes", type=int, default=DEFAULTS.num_scenes, help="to learn from (%(default)s)"
    )
    parser.add_argument(
        "--scenario", default=DEFAULTS.scenario, help="where they are from (%(default)s)"
    )
    parser.add_argument(
        "--updates", type=int, default=DEFAULTS.num_updates, help="gradient steps (%(default)s)"
    )
    parser.add_argument(
        "--seed", type=int, default=DEFAULTS.seed, help="decides everything random (%(default)s)"
    )
    parser.add_argument(
        "--unseen",
        type=int,
        default=1000,
        metavar="N",
        help="scenes to measure it on (%(default)s)",
    )
    parser.add_argument("--threads", type=int, default=1, help="threads of torch (%(default)s)")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="where to put it")
    parser.add_argument(
        "--overwrite", action="store_true", help="replace a checkpoint that is there already"
    )
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    config = AutoencoderConfig(
        scenario=args.scenario, num_scenes=args.scenes, num_updates=args.updates, seed=args.seed
    )
    check_int("unseen", args.unseen, 1, 1_000_000)
    check_int("threads", args.threads, 1, 256)
    check_checkpoint_target("out", args.out, may_overwrite=args.overwrite)
    import torch

    from singulate.agents.autoencoder.training import make_autoencoder

    torch.set_num_threads(args.threads)
    torch.set_flush_denormal(True)
    began = time.monotonic()
    with StepBars() as bars:
        quality = make_autoencoder(config, args.unseen, args.out, bars.show)
    seconds = time.monotonic() - began
    if args.json:
        about = {"out": str(args.out), **quality.to_dict(), "seconds": round(seconds, 1)}
        print(json.dumps(about))
    else:
        print(
            f"On {quality.num_scenes:,} unseen scenes the reconstruction is "
            f"{quality.mean_absolute_error_px:.2f} px off on average; it finds "
            f"{quality.object_pixels_found:.1%} of the object pixels, and the masks overlap by "
            f"{quality.mask_overlap:.1%} ({seconds:.0f} s).\n"
            f"Look through it: singulate train --agent dqn --set encoder={args.out}"
        )
    return 0
