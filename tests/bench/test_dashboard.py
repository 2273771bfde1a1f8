import sys
import time
from pathlib import Path

import psutil
import pytest

from singulate.bench.dashboard_drag import drag_block
from singulate.bench.dashboard_page import open_page
from singulate.bench.dashboard_process import pushes_per_second, running_dashboard, running_trainer
from singulate.bench.dashboard_socket import open_socket
from singulate.bench.dashboard_tax import Tax, measure_tax, stopped, tree
from singulate.exceptions import SingulateError


@pytest.mark.browser
def test_a_page_that_is_not_there_is_one_clear_line(tmp_path: Path) -> None:
    with (
        pytest.raises(SingulateError, match="does not answer") as caught,
        open_page("http://127.0.0.1:9/", tmp_path),
    ):
        pass
    assert "\n" not in str(caught.value)


def test_speed_is_read_from_a_real_training(tmp_path: Path) -> None:
    run_dir = tmp_path / "run"
    with running_trainer(run_dir):
        assert pushes_per_second(run_dir, seconds=0.1) > 1.0
    with pytest.raises(SingulateError, match="trainer"):
        pushes_per_second(run_dir, seconds=0.1)


def test_a_stopped_process_does_not_work_and_goes_on_afterwards() -> None:
    process = psutil.Popen([sys.executable, "-c", "while True: pass"])
    try:
        with stopped(tree(process.pid)):
            before = process.cpu_times().user
            time.sleep(0.3)
            assert process.cpu_times().user == before
        deadline = time.monotonic() + 30.0
        while process.cpu_times().user == before:
            assert time.monotonic() < deadline, "it does not go on"
            time.sleep(0.01)
    finally:
        process.kill()
        process.wait()


def test_speed_kept_is_the_median_of_the_pairs() -> None:
    tax = Tax([10.0, 20.0, 40.0], [9.0, 20.0, 20.0])
    assert tax.speed_kept == 0.9
    assert tax.quartiles == pytest.approx((0.7, 0.95))


def test_a_page_and_its_standing_still_take_turns(tmp_path: Path) -> None:
    run_dir, page = tmp_path / "run", psutil.Popen([sys.executable, "-c", "while True: pass"])
    states = []
    with running_trainer(run_dir):
        try:
            tax = measure_tax(run_dir, tree(page.pid), 0.1, 2, lambda: states.append(page.status()))
            assert psutil.STATUS_STOPPED not in [*states, page.status()]
        finally:
            page.kill()
            page.wait()
    assert len(states) == len(tax.alone) == len(tax.beside) == 2
    assert min(tax.alone + tax.beside) > 0.0


@pytest.mark.slow
@pytest.mark.browser
def test_a_drag_on_the_real_page_is_timed(tmp_path: Path) -> None:
    with (
        running_dashboard(tmp_path, scenario="random-3") as dashboard,
        open_page(dashboard.url, tmp_path) as page,
    ):
        page.wait_for_reward_map()
        (pause,) = drag_block(page, [(-0.5, 0.4)])
    assert 0.0 < pause.coarse_s < pause.full_s
    assert pause.pictures_per_second > 0.0


@pytest.mark.slow
@pytest.mark.browser
def test_a_click_on_the_real_page_is_timed(tmp_path: Path) -> None:
    with (
        running_dashboard(tmp_path) as dashboard,
        open_page(dashboard.url, tmp_path, niceness=1) as page,
    ):
        clicks = [page.click(-0.8, -0.7), page.click(0.8, -0.7)]
        assert page.pictures_per_second(0.5) > 0.0
    for click in clicks:
        assert 0.0 < click.motion < click.picture < 30.0


def test_a_click_over_the_websocket_is_timed(tmp_path: Path) -> None:
    with running_dashboard(tmp_path) as dashboard, open_socket(dashboard.url) as socket:
        assert 0.0 < socket.click(-0.8, -0.7) < 30.0
        assert 0.0 < socket.click(0.8, -0.7) < 30.0


def test_a_dashboard_that_does_not_start_says_why(tmp_path: Path) -> None:
    with (
        pytest.raises(SingulateError, match=r"does not start: .*nowhere"),
        running_dashboard(tmp_path, tmp_path / "nowhere"),
    ):
        pass
