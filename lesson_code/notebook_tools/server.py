"""The workbook in a browser: JupyterLab, started at notebook 00."""

from __future__ import annotations

import importlib.util
import os
import secrets
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from dataclasses import dataclass
from pathlib import Path

USUAL_PORT = 8888
SECONDS_TO_START = 60.0
"""JupyterLab answers after 2 to 10 s, even on a slow machine."""


class ServerError(RuntimeError):
    """JupyterLab is not installed, or did not start; the message says what to do."""


@dataclass(frozen=True)
class Server:
    """A running JupyterLab and the address at which notebook 00 opens."""

    process: subprocess.Popen[bytes]
    address: str

    def stop(self) -> None:
        """End the server."""
        self.process.terminate()
        try:
            self.process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            self.process.kill()


def has_screen() -> bool:
    """Return whether a browser window can be opened on this machine."""
    if sys.platform in ("win32", "darwin"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def start(root: Path, notebook: Path, port: int | None = None) -> Server:
    """Start JupyterLab and return once it answers.

    Parameters
    ----------
    root : Path
        The folder to serve.
    notebook : Path
        The notebook to open, relative to `root`.
    port : int, optional
        8888 by default, or another one if that is taken.

    Raises
    ------
    ServerError
        JupyterLab is missing or does not start.
    """
    if importlib.util.find_spec("jupyterlab") is None:
        raise ServerError("JupyterLab is not installed: pip install -e '.[jupyter]'")
    chosen, token = port or _free_port(), secrets.token_hex(24)
    command = [
        sys.executable,
        "-m",
        "jupyterlab",
        "--no-browser",
        f"--ServerApp.root_dir={root}",
        f"--ServerApp.port={chosen}",
        "--ServerApp.port_retries=0",
        "--ServerApp.log_level=ERROR",
    ]
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        command.append("--allow-root")
    process = subprocess.Popen(  # noqa: S603 - our own interpreter
        command, env={**os.environ, "JUPYTER_TOKEN": token}
    )
    server = Server(
        process, f"http://127.0.0.1:{chosen}/lab/tree/{notebook.as_posix()}?token={token}"
    )
    _wait_for(server, f"http://127.0.0.1:{chosen}/api")
    return server


def _free_port() -> int:
    """Return the usual port, or one that is free if that is taken."""
    for port in (USUAL_PORT, 0):
        with socket.socket() as tried:
            try:
                tried.bind(("127.0.0.1", port))
            except OSError:
                continue
            return int(tried.getsockname()[1])
    raise ServerError("no free port on this machine")


def _wait_for(server: Server, url: str) -> None:
    """Return when the server answers, or stop it and say that it does not."""
    end = time.monotonic() + SECONDS_TO_START
    while time.monotonic() < end:
        if server.process.poll() is not None:
            raise ServerError("JupyterLab ended before it was ready; its own words stand above")
        try:
            with urllib.request.urlopen(url, timeout=2):  # noqa: S310 - our own address
                return
        except (urllib.error.URLError, OSError):
            time.sleep(0.1)
    server.stop()
    raise ServerError(f"JupyterLab did not answer within {SECONDS_TO_START:g} s")
