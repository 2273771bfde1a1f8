"""The real dashboard in a process of its own, looked at through headless Chromium."""

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Literal

import pytest
from playwright.sync_api import Browser, BrowserContext, sync_playwright

from .lab_page import IS_STEADY, LabPage

ROOT = Path(__file__).resolve().parents[3]
SIZE = {"width": 1280, "height": 720}

CHROMIUM_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
FLAGS = [
    "--headless=new",
    "--enable-unsafe-swiftshader",
    "--disable-dev-shm-usage",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-default-apps",
    "--disable-sync",
    "--no-first-run",
]


@pytest.fixture(scope="package")
def browser() -> Iterator[Browser]:
    path = next(filter(None, map(shutil.which, CHROMIUM_NAMES)), None)
    flags = [*FLAGS, "--no-sandbox"] if os.geteuid() == 0 else FLAGS
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=flags)
        yield chromium
        chromium.close()


@pytest.fixture(scope="package")
def opened(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file for the address that a person's own browser is asked to open."""
    return tmp_path_factory.mktemp("opened") / "address.txt"


@pytest.fixture(scope="package")
def app_process(
    tmp_path_factory: pytest.TempPathFactory, opened: Path
) -> Iterator[subprocess.Popen[str]]:
    log = (tmp_path_factory.mktemp("app") / "stderr.txt").open("w+")
    own_browser = opened.with_name("browser.sh")
    own_browser.write_text(f"#!/bin/sh\nprintf %s \"$1\" > '{opened}'\n")
    own_browser.chmod(0o755)
    scene = ("--scenario", "random-2", "--seed", "0")
    process = subprocess.Popen(
        [sys.executable, "-m", "app", "--port", "0", "--open", *scene],
        cwd=ROOT,
        env=os.environ
        | {"SINGULATE_RUNS": str(tmp_path_factory.mktemp("runs")), "BROWSER": str(own_browser)},
        stdout=subprocess.PIPE,
        stderr=log,
        text=True,
    )
    assert process.stdout is not None
    yield process
    process.send_signal(signal.SIGINT)
    try:
        status = process.wait(timeout=30)
    except subprocess.TimeoutExpired:
        process.kill()
        raise
    finally:
        log.seek(0)
        print(log.read())
        log.close()
        rest = process.stdout.read()
        process.stdout.close()
    assert status == 0
    assert rest == "", "the address is the only line that the program prints"


@pytest.fixture(scope="package")
def app_url(app_process: subprocess.Popen[str]) -> str:
    assert app_process.stdout is not None
    line = app_process.stdout.readline()
    assert line.startswith("singulate: open http://127.0.0.1:"), line
    return line.split()[-1]


@pytest.fixture(scope="package")
def open_page(browser: Browser, app_url: str) -> Iterator[Callable[..., LabPage]]:
    """Opens windows of separate visitors, whose systems may prefer a theme."""
    contexts: list[BrowserContext] = []

    def open_one(prefers: Literal["light", "dark"] = "light") -> LabPage:
        contexts.append(browser.new_context(viewport=SIZE, color_scheme=prefers))  # type: ignore[arg-type]
        return LabPage(contexts[-1], app_url).open()

    yield open_one
    for context in contexts:
        context.close()  # closing twice does no harm


@pytest.fixture(scope="package")
def shared_page(open_page: Callable[..., LabPage]) -> LabPage:
    return open_page()


@pytest.fixture
def page(shared_page: LabPage) -> Iterator[LabPage]:
    """The first visitor's window with the first scene at rest; it must stay free of errors."""
    shared_page.wait(lambda: not shared_page.is_pushing)
    shared_page.press("r")
    shared_page.wait(lambda: "rearranged" not in shared_page.text)
    shared_page.page.wait_for_function(IS_STEADY, timeout=60_000, polling=200)
    yield shared_page
    assert shared_page.errors == []
