from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from singulate.envs import EnvConfig
from singulate.exceptions import InvalidValueError
from singulate.experiments.figures.paper_figure import Data
from singulate.experiments.figures.plan import Plan, quick_plan
from singulate.experiments.figures.registry import FIGURES, parse_figures
from singulate.experiments.figures.style import save_figure
from singulate.experiments.figures.training_curve import stacked, training_curve
from singulate.experiments.figures.variants import VARIANTS
from singulate.rewards import make_reward
from singulate.runs import RunReader
from singulate.training.config import TrainingConfig
from singulate.training.trainer import train

BLOCKS = [[[0.0, -0.1], [0.2, -0.1], [0.2, 0.1], [0.0, 0.1]]]
LABELS = ["up", "right", "down", "left"]


def curves(*levels: float) -> list[dict[str, object]]:
    steps = [2000.0 * i for i in range(1, 31)]
    return [
        {
            "num_steps": 60_000,
            "curve": {"steps": steps, "reward": [level] * 30, "success": [level / 1000] * 30},
        }
        for level in levels
    ]


def example(name: str) -> Data:
    rng = np.random.default_rng(0)
    maps = rng.uniform(-100, 1000, (4, 10, 10)).tolist()
    moments = [{"step": s, "counts": rng.integers(0, 9, (32, 32)).tolist()} for s in (2, 4, 6)]
    by_variant = {variant: curves(100, 500, 900) for variant in FIGURES[name].variants}
    return {
        "fig1": {
            "rgb": rng.integers(0, 255, (64, 64, 3)).tolist(),
            "mask": rng.integers(0, 2, (64, 64)).tolist(),
            "distance_map_px": rng.uniform(-1, 9, (64, 64)).tolist(),
        },
        "fig2": {
            "directions": LABELS,
            "scenes": [{"scenario": "random-2", "rewards": maps, "blocks": BLOCKS}] * 2,
        },
        "fig3": {"runs": by_variant},
        "fig4": {"runs": by_variant, "num_pretraining_pushes": 40_000},
        "fig5": {
            "directions": LABELS,
            "blocks": BLOCKS,
            "rewards": maps,
            "seeds": [{"num_steps": 4000, "q_map": maps}],
        },
        "fig6": {
            "blocks": BLOCKS,
            "seeds": [{"seed": seed, "moments": moments} for seed in (0, 1)],
        },
        "autoencoder": {
            "runs": by_variant,
            "quality": {"mean_absolute_error_px": 0.7},
            "scenes": [
                {
                    "scenario": "random-2",
                    "map_px": rng.uniform(-1, 9, (64, 64)).tolist(),
                    "reconstruction_px": rng.uniform(-1, 9, (64, 64)).tolist(),
                }
            ]
            * 6,
        },
        "ideas": {"runs": by_variant},
    }[name]


@pytest.mark.parametrize("name", FIGURES)
def test_pictures_are_readable_in_print_and_the_same_bytes_each_time(
    name: str, tmp_path: Path
) -> None:
    data = example(name)
    for file in ("one.png", "other.png"):
        save_figure(FIGURES[name].draw(data), tmp_path / file)
    with Image.open(tmp_path / "one.png") as picture:
        assert picture.width == 1400
        assert np.asarray(picture.convert("L")).std() > 10.0
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "other.png").read_bytes()


def test_trainings_are_those_that_the_paper_compares() -> None:
    ours = VARIANTS["ppo-fixed-2"].env
    assert (ours.observation, ours.action, ours.reward) == ("distance_map", "point", "paper")
    assert VARIANTS["ppo-fixed-2-mask"].env == EnvConfig("fixed-2", observation="mask")
    same_network = VARIANTS["mixture-ppo-1-random-2"].cells(Plan())[0].training
    assert same_network.agent_config["num_components"] == 1
    known = {variant for figure in FIGURES.values() for variant in figure.variants}
    assert known <= set(VARIANTS)
    table_1 = VARIANTS["ppo-fixed-2"].cells(Plan())[0].training.agent_config
    names = ("learning_rate", "batch_size", "n_steps", "n_epochs")
    assert [table_1[name] for name in names] == [5e-4, 4, 2048, 3]


def test_shorter_plans_keep_the_lengths_that_the_paper_gives() -> None:
    plan = Plan(max_steps=30_000)
    lengths = {
        name: variant.cells(plan)[0].training.total_timesteps for name, variant in VARIANTS.items()
    }
    assert lengths["ppo-fixed-2"] == lengths["trpo-random-2"] == 30_000
    assert lengths["ppo-fixed-2-start"] == lengths["ppo-fixed-2-pretrained"] == 60_000
    assert (lengths["dqn-random-2"], lengths["dqn-fixed-2-start"]) == (20_000, 4_000)
    quick = [v.cells(quick_plan())[0].training.total_timesteps for v in VARIANTS.values()]
    assert max(quick) == 2048
    assert len(VARIANTS["ppo-fixed-2"].cells(Plan(seeds=(0, 4)))) == 2


@pytest.mark.parametrize("values", [{"seeds": ()}, {"seeds": (-1,)}, {"max_steps": 10}])
def test_plans_that_make_no_sense_are_refused(values: dict[str, object]) -> None:
    with pytest.raises(InvalidValueError):
        Plan(**values)  # type: ignore[arg-type]


def test_figures_by_name() -> None:
    assert [figure.name for figure in parse_figures(["fig5", "fig1", "fig5"])[0]] == [
        "fig1",
        "fig5",
    ]
    assert parse_figures(["fig1"])[1] is False
    assert parse_figures([]) == parse_figures(["all"]) == (list(FIGURES.values()), True)
    with pytest.raises(InvalidValueError, match="fig9"):
        parse_figures(["fig9"])


def test_a_curve_is_what_the_record_says_on_the_scale_of_eq_7(tmp_path: Path) -> None:
    env = EnvConfig("fixed-2", action="grid", reward="separation")
    settings = {"learning_starts": 10_000, "net_arch": [8]}
    train(TrainingConfig("dqn", env, 450, agent_config=settings), tmp_path / "run")
    curve = training_curve(tmp_path / "run", 400)
    reader = RunReader(tmp_path / "run")
    pushes = reader.pushes_since()
    reader.close()
    assert curve["steps"] == [100.0, 200.0, 300.0, 400.0]
    expected = [
        np.mean([make_reward("paper").total(push.terms) for push in pushes[i : i + 100]])
        for i in (0, 100, 200, 300)
    ]
    assert curve["reward"] == pytest.approx(expected, abs=0.01)
    rates = [np.mean([push.is_success for push in pushes[i : i + 100]]) for i in (0, 100, 200, 300)]
    assert curve["success"] == pytest.approx(rates)


def test_curves_of_seeds_are_cut_to_what_all_have() -> None:
    runs = curves(1.0, 2.0)
    runs[1]["curve"] = {"steps": [2000.0], "reward": [3.0], "success": [0.5]}
    steps, values = stacked(runs, "reward")
    assert (steps.tolist(), values.tolist()) == ([2000.0], [[1.0], [3.0]])
