"""Pushes per second of the environment, where their time goes, and its peers."""

from collections.abc import Iterator
from contextlib import ExitStack

from singulate.bench.measurement import BenchOptions, Measurement
from singulate.bench.memory import workers_peak_mib
from singulate.bench.peers import PEERS, PeerSpec, run_peer
from singulate.bench.push_parts import PushParts, TimedEnv, time_parts
from singulate.bench.pushes import make_env, push_at_random, push_touching
from singulate.bench.turns import Rate, Turn, Variant, take_turns
from singulate.engine import EngineError, LocalEngine

SCENARIO = "random-2"
_KINDS = {"random pushes": push_at_random, "touching pushes": push_touching}
_HOW = {"fast": "what cannot move a block is left out", "plain": "every step simulated"}
_PICTURES = 2
"""Of 64 x 64, one before and one after a push."""


def bench_env(options: BenchOptions) -> Iterator[Measurement]:
    """Time whole episodes of one push (reset and step) in turns with those of peers."""
    with ExitStack() as stack:
        engines = {n: stack.enter_context(_engine(n)) for n in options.worker_counts}
        variants = {
            _name(kind, how, num_workers): Variant(
                engine, work, make_env(SCENARIO, exact=how == "plain")
            )
            for num_workers, engine in engines.items()
            for kind, work in _KINDS.items()
            for how in _HOW
        }
        peers = {
            name: Variant(stack.enter_context(_engine(1)), run_peer, spec.tool)
            for name, spec in PEERS.items()
            if spec.is_installed
        }
        broken = {name: error for name, peer in peers.items() if (error := _start(peer))}
        working = {name: peer for name, peer in peers.items() if name not in broken}
        rates = take_turns(variants | working, options.seconds)
        yield from _pushes(rates, options.worker_counts)
        with _engine(1) as engine:
            yield from _parts(_time_parts(engine, options.seconds))
        note = "resident, of a worker with both environments"
        yield Measurement("peak memory", workers_peak_mib(engines[1]), "MiB", note)
        for name, spec in PEERS.items():
            yield from _peer(name, spec, rates, broken.get(name))
            if name in working:
                peak = workers_peak_mib(working[name].engine)
                yield Measurement(f"{name}, peak memory", peak, "MiB", "resident")


def _engine(num_workers: int) -> LocalEngine:
    return LocalEngine(num_workers, niceness=0)


def _start(peer: Variant) -> str | None:
    """Why a peer does not work here, if it does not."""
    try:
        for result in peer.engine.submit(run_peer, [Turn(0.0, 0)], peer.tool):
            _ = result.value
    except EngineError as error:
        return str(error)
    return None


def _name(kind: str, how: str, num_workers: int) -> str:
    return f"{kind}, {how}, {num_workers} worker{'s' * (num_workers > 1)}"


def _pushes(rates: dict[str, Rate], worker_counts: tuple[int, ...]) -> Iterator[Measurement]:
    for kind in _KINDS:
        for num_workers in worker_counts:
            for how, note in _HOW.items():
                name = _name(kind, how, num_workers)
                note = f"{SCENARIO}, reset and step; {note}"
                yield Measurement(name, rates[name].steps, "pushes/s", note)
            fast, plain = (rates[_name(kind, how, num_workers)].steps for how in _HOW)
            name = _name(kind, "gain", num_workers)
            yield Measurement(name, fast / plain, "", "fast against plain, in turns")
        if (most := worker_counts[-1]) > 1:
            gain = rates[_name(kind, "fast", most)].steps / rates[_name(kind, "fast", 1)].steps
            yield Measurement(f"{kind}, {most} workers against 1", gain, "", "fast, in turns")
    for how in _HOW:
        name = f"touching pushes, {how}"
        rate = rates[_name("touching pushes", how, 1)]
        yield Measurement(f"{name}, pictures", _PICTURES * rate.steps, "1/s", "1 worker, 64 x 64")
        note = "1 worker; seconds on the table in a second, those left out included"
        yield Measurement(f"{name}, simulated time", rate.simulated, "s/s", note)


def _time_parts(engine: LocalEngine, seconds: float) -> PushParts:
    (result,) = engine.submit(time_parts, [Turn(seconds, 0)], _timed_env)
    return result.value


def _timed_env() -> TimedEnv:
    return TimedEnv(SCENARIO)


def _parts(parts: PushParts) -> Iterator[Measurement]:
    seconds = {"physics": parts.physics, "image": parts.image, "perception": parts.perception}
    seconds["rest"] = parts.total - sum(seconds.values())
    what = {"image": ", two pictures", "rest": ", Python: scenes, rewards, observations, checks"}
    for part, spent in seconds.items():
        note = f"{spent / parts.total:.0%} of a touching push{what.get(part, '')}"
        yield Measurement(f"touching push, {part}", 1e3 * spent, "ms", note)
    note = f"part of physics: {parts.num_solver_steps:.0f} calls of Bullet's stepSimulation"
    yield Measurement("touching push, solver", 1e3 * parts.solver, "ms", note)


def _peer(
    name: str, spec: PeerSpec, rates: dict[str, Rate], error: str | None
) -> Iterator[Measurement]:
    if name not in rates:
        note = f"does not start: {error}" if error else f"not installed: {spec.install}"
        yield Measurement(name, None, "steps/s", note)
        return
    ours, theirs = rates[_name("touching pushes", "fast", 1)], rates[name]
    yield Measurement(name, theirs.steps, "steps/s", spec.note)
    note = "seconds on the table in a second"
    yield Measurement(f"{name}, simulated time", theirs.simulated, "s/s", note)
    note = "in turns: pictures a second, touching pushes against it"
    yield Measurement(f"{name}, our pictures", _PICTURES * ours.steps / theirs.steps, "", note)
    note = "in turns: simulated time a second, touching pushes against it"
    yield Measurement(f"{name}, our time", ours.simulated / theirs.simulated, "", note)
