import socket
import subprocess
import sys

import engine_tasks as tasks
import pytest

from singulate.engine import EngineError, open_engine
from singulate.engine.ray_engine import RayEngine
from singulate.exceptions import InvalidValueError

COMMANDS_WITHOUT_RAY = """
import sys
from singulate.cli import main
assert main(["rewardmap", "--resolution", "4", "--workers", "1", "--json"]) == 0
assert main(["evaluate", "random", "--episodes", "40", "--workers", "2", "--json"]) == 0
print("ray" in sys.modules, file=sys.stderr)
"""


@pytest.fixture
def closed_port() -> int:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return int(listener.getsockname()[1])


def test_nothing_imports_ray_unless_asked() -> None:
    command = [sys.executable, "-c", COMMANDS_WITHOUT_RAY]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert done.stderr.splitlines()[-1] == "False"


@pytest.mark.usefixtures("local_ray")
def test_a_hung_worker_is_replaced() -> None:
    with RayEngine(num_workers=1, hang_timeout_s=0.3) as engine:
        (result,) = engine.submit(tasks.sleep, [60.0], object)
        assert result.error is not None
        assert "2 workers died" in result.error
        assert "\n" not in result.error


@pytest.mark.usefixtures("local_ray")
def test_a_result_that_cannot_be_sent_is_reported() -> None:
    with RayEngine(num_workers=1) as engine:
        (result,) = engine.submit(tasks.unsendable, [1], object)
        assert result.error is not None
        assert [r.value for r in engine.submit(tasks.square, [4], object)] == [16]


@pytest.mark.usefixtures("local_ray")
def test_workers_beyond_the_cores_wait_without_harm() -> None:
    with RayEngine(num_workers=9) as engine:
        results = engine.submit(tasks.square, list(range(40)), object)
        assert {r.index: r.value for r in results} == {i: i * i for i in range(40)}


@pytest.mark.usefixtures("local_ray")
def test_it_has_a_worker_for_each_core_of_the_cluster() -> None:
    with open_engine("ray") as engine:
        assert engine.num_workers >= 2


@pytest.mark.parametrize("address", ["nowhere", "ray://host:1", "host:0", ":6379", "host:99999"])
def test_what_is_no_address_is_refused(address: str) -> None:
    with pytest.raises(InvalidValueError, match=r"address: .* HOST:PORT"):
        open_engine("ray", address)


def test_an_address_that_nobody_listens_at_is_refused(closed_port: int) -> None:
    with pytest.raises(InvalidValueError, match="that can be reached"):
        open_engine("ray", f"127.0.0.1:{closed_port}")


def test_without_the_extra_the_remedy_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("singulate.engine.opening.find_spec", lambda name: None)
    with pytest.raises(EngineError, match=r"pip install 'singulate\[ray\]'"):
        open_engine("ray")


@pytest.mark.parametrize(
    ("name", "address", "key"), [("dask", None, "engine"), ("local", "auto", "address")]
)
def test_other_names_and_stray_addresses_are_refused(
    name: str, address: str | None, key: str
) -> None:
    with pytest.raises(InvalidValueError, match=key):
        open_engine(name, address)


@pytest.mark.parametrize(("key", "value"), [("num_workers", 0), ("niceness", 20)])
def test_values_out_of_range_are_refused(key: str, value: int) -> None:
    arguments = {"num_workers": 1} | {key: value}
    with pytest.raises(InvalidValueError, match=key):
        RayEngine(**arguments)
