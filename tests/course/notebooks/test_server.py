"""The workbook in a browser: JupyterLab is started, answers, and is gone afterwards."""

from __future__ import annotations

import importlib.util
import socket
import subprocess
import sys
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import nbformat
import pytest
from nbformat.sign import NotebookNotary

from lesson_code.course.notebooks import server
from lesson_code.course.notebooks.server import HOST, JupyterServer, ServerError

NOTEBOOK = Path("notebooks") / "00 start.ipynb"
NEEDS_JUPYTERLAB = pytest.mark.skipif(
    importlib.util.find_spec("jupyterlab") is None,
    reason="needs JupyterLab: pip install -e '.[jupyter]'",
)
FORGETFUL = """
import signal, time
signal.signal(signal.SIGTERM, signal.SIG_IGN)
print("up", flush=True)
time.sleep(10)
"""


def python(code: str) -> subprocess.Popen[bytes]:
    """Start a Python process that stands for JupyterLab."""
    return subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE)


def answer(url: str) -> int:
    """Return the status of a GET, no proxy asked."""
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    with opener.open(url, timeout=10) as response:
        return int(response.status)


def is_free(port: int) -> bool:
    """Return whether nobody listens on a port."""
    with socket.socket() as tried:
        return tried.connect_ex((HOST, port)) != 0


@pytest.fixture
def taken() -> Iterator[int]:
    """Yield a port on which somebody listens, without ever answering."""
    with socket.socket() as listening:
        listening.bind((HOST, 0))
        listening.listen()
        yield listening.getsockname()[1]


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> list[subprocess.Popen[bytes]]:
    """Start a process that never answers in place of JupyterLab; collect what was started."""
    processes: list[subprocess.Popen[bytes]] = []
    popen = subprocess.Popen

    def start_another(*_: object, **__: object) -> subprocess.Popen[bytes]:
        processes.append(popen([sys.executable, "-c", "import time; time.sleep(60)"]))
        return processes[-1]

    monkeypatch.setattr(server.importlib.util, "find_spec", lambda _: True)
    monkeypatch.setattr(server.subprocess, "Popen", start_another)
    return processes


def test_missing_jupyterlab_is_said_with_the_command_that_installs_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Whoever installed the lean package learns what to type."""
    monkeypatch.setattr(server.importlib.util, "find_spec", lambda _: None)
    with pytest.raises(ServerError, match=r'pip install -e "\.\[jupyter\]"'):
        server.start(tmp_path, NOTEBOOK)


def test_usual_port_is_used_when_it_is_free(monkeypatch: pytest.MonkeyPatch, taken: int) -> None:
    """Another one is chosen only if the usual one is taken."""
    other = server._free_port([taken, 0])
    assert other not in (taken, 0)
    assert server._free_port([other, 0]) == other


@NEEDS_JUPYTERLAB
def test_taken_port_that_was_asked_for_is_refused(taken: int, tmp_path: Path) -> None:
    """Somebody else's server on that port is not taken for ours."""
    with pytest.raises(ServerError, match=f"port {taken} cannot be used"):
        server.start(tmp_path, NOTEBOOK, port=taken)


def test_server_that_ends_at_once_is_an_error(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """A JupyterLab that cannot start is reported at once, not after a minute."""
    monkeypatch.setattr(server.importlib.util, "find_spec", lambda _: True)
    monkeypatch.setattr(
        server, "_command", lambda *_: [sys.executable, "-c", "raise SystemExit(1)"]
    )
    with pytest.raises(ServerError, match="ended before it was ready"):
        server.start(tmp_path, NOTEBOOK)


def test_server_that_never_answers_is_stopped(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, started: list[subprocess.Popen[bytes]]
) -> None:
    """After the time it may take, the error says so and the process is gone."""
    monkeypatch.setattr(server, "SECONDS_TO_START", 0.3)
    with pytest.raises(ServerError, match=r"did not answer within 0\.3 s"):
        server.start(tmp_path, NOTEBOOK)
    assert started[0].poll() is not None


def test_ctrl_c_while_it_starts_leaves_no_server(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, started: list[subprocess.Popen[bytes]]
) -> None:
    """An impatient user does not collect servers."""

    def press_ctrl_c(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(server, "_wait_for", press_ctrl_c)
    with pytest.raises(KeyboardInterrupt):
        server.start(tmp_path, NOTEBOOK)
    assert started[0].poll() is not None


def test_settings_of_its_own_leave_those_of_the_user_alone(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """A folder for settings is handed over; without one the user's own are used."""
    environments: list[dict[str, str]] = []

    def start_nothing(*_: object, env: dict[str, str]) -> None:
        environments.append(env)

    monkeypatch.setattr(server.importlib.util, "find_spec", lambda _: True)
    monkeypatch.setattr(server.subprocess, "Popen", start_nothing)
    monkeypatch.setattr(server, "_wait_for", lambda *_: None)
    monkeypatch.setenv("JUPYTER_CONFIG_DIR", "the user's")
    server.start(tmp_path, NOTEBOOK)
    server.start(tmp_path, NOTEBOOK, config=tmp_path)
    found = [environment["JUPYTER_CONFIG_DIR"] for environment in environments]
    assert found == ["the user's", str(tmp_path)]


def test_server_that_does_not_want_to_end_is_killed(monkeypatch: pytest.MonkeyPatch) -> None:
    """After `stop` the process is gone, whatever it thinks of SIGTERM."""
    monkeypatch.setattr(server, "SECONDS_TO_STOP", 0.2)
    with python(FORGETFUL) as process:
        assert process.stdout is not None
        process.stdout.readline()
        JupyterServer(process, "").stop()
        assert process.poll() not in (None, 0)


def test_stopping_a_server_that_is_gone_is_no_error() -> None:
    """JupyterLab may have been shut down from its own menu."""
    with python("") as process:
        process.wait()
        JupyterServer(process, "").stop()


@pytest.mark.parametrize(
    ("platform", "environment", "expected"),
    [
        ("linux", {}, False),
        ("linux", {"DISPLAY": ":0"}, True),
        ("linux", {"WAYLAND_DISPLAY": "wayland-0"}, True),
        ("linux", {"DISPLAY": "", "WAYLAND_DISPLAY": ""}, False),
        ("win32", {}, True),
        ("darwin", {}, True),
    ],
)
def test_screen_is_known_by_the_environment(
    monkeypatch: pytest.MonkeyPatch, platform: str, environment: dict[str, str], expected: bool
) -> None:
    """On Linux a display is named in the environment; Windows and macOS have one."""
    monkeypatch.setattr(server.sys, "platform", platform)
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert server.has_screen() is expected


@NEEDS_JUPYTERLAB
def test_server_answers_and_is_gone_after_stop(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, taken: int
) -> None:
    """For real: the usual port is taken, a web proxy is set, and the address still answers."""
    monkeypatch.setattr(server, "USUAL_PORT", taken)
    monkeypatch.setenv("http_proxy", f"http://{HOST}:{taken}")
    (tmp_path / NOTEBOOK).parent.mkdir()
    (tmp_path / NOTEBOOK).write_text(
        '{"cells": [], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}', encoding="utf-8"
    )
    running = server.start(tmp_path, NOTEBOOK)
    try:
        port = int(running.address.split(":")[2].split("/")[0])
        assert port != taken
        assert "/lab/tree/notebooks/00%20start.ipynb?token=" in running.address
        assert answer(running.address) == 200
        assert answer(running.address.replace("/lab/tree/", "/api/contents/")) == 200
    finally:
        running.stop()
    assert running.process.poll() is not None
    assert is_free(port)


def test_trusted_notebook_is_signed_and_no_longer_when_it_is_changed(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """By the signature that JupyterLab looks for when it opens a notebook."""
    monkeypatch.setenv("JUPYTER_DATA_DIR", str(tmp_path / "data"))
    output = nbformat.v4.new_output("display_data", data={"text/html": "<script></script>"})
    cell = nbformat.v4.new_code_cell("lab()", outputs=[output])
    paths = [tmp_path / "signed.ipynb", tmp_path / "other.ipynb"]
    for path in paths:
        nbformat.write(nbformat.v4.new_notebook(cells=[cell]), path)
        cell["source"] += "  # another"
    server.trust(paths[:1])
    notebooks = [nbformat.read(path, as_version=4) for path in paths]
    notary = NotebookNotary()
    assert [notary.check_signature(notebook) for notebook in notebooks] == [True, False]
    notebooks[0].cells[0].outputs[0].data["text/html"] = "<script>another</script>"
    assert not notary.check_signature(notebooks[0])


def test_home_that_cannot_be_written_is_no_error(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """The notebook opens all the same; its reader runs the cells first."""
    (tmp_path / "file").touch()
    monkeypatch.setenv("JUPYTER_DATA_DIR", str(tmp_path / "file" / "data"))
    nbformat.write(nbformat.v4.new_notebook(), tmp_path / "one.ipynb")
    server.trust([tmp_path / "one.ipynb"])
