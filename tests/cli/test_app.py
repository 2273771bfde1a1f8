import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
CODE = "import sys; sys.path.insert(0, sys.argv.pop(1)); from singulate.cli import main; main()"


def test_another_project_called_app_is_not_started(tmp_path: Path) -> None:
    (tmp_path / "app").mkdir()
    (tmp_path / "app" / "__init__.py").touch()
    (tmp_path / "app" / "__main__.py").write_text("print('another project')")
    done = subprocess.run(
        [sys.executable, "-c", CODE, str(ROOT), "app", "--help"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={key: value for key, value in os.environ.items() if key != "PYTHONPATH"},
        timeout=60,
    )
    assert done.returncode == 0, done.stderr
    assert "usage: singulate app [-h] [--host HOST]" in done.stdout


def test_options_are_passed_on() -> None:
    command = [sys.executable, "-m", "singulate", "app", "--port", "70000"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "singulate: error: --port: 70000 is not allowed; allowed: 0 to 65535\n"
