"""The workbook in a browser: JupyterLab, started at notebook 00."""

from __future__ import annotations

import http.client
import importlib.util
import os
import secrets
import socket
import sqlite3
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote

from lesson_code.course.notebooks.root import how_to_install

HOST = "127.0.0.1"
USUAL_PORT = 8888
SECONDS_TO_START = 60.0
"""JupyterLab answers after 2 to 10 s, even on a slow machine."""

SECONDS_TO_STOP = 10.0
"""It ends its kernels first; each is given some seconds to go by itself."""


class ServerError(RuntimeError):
    """JupyterLab is not installed, or did not start; the message says what to do."""


@dataclass(frozen=True)
class JupyterServer:
    """A running JupyterLab and the address at which notebook 00 opens."""

    process: subprocess.Popen[bytes]
    address: str

    def stop(self) -> None:
        """End the server, and with it the kernels it runs."""
        self.process.terminate()
        try:
            self.process.wait(timeout=SECONDS_TO_STOP)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()


def has_screen() -> bool:
    """Return whether a browser window can be opened on this machine."""
    if sys.platform in ("win32", "darwin"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def start(
    root: Path, notebook: Path, port: int | None = None, config: Path | None = None
) -> JupyterServer:
    """Start JupyterLab and return once it answers.

    Parameters
    ----------
    root : Path
        The folder to serve.
    notebook : Path
        The notebook to open, relative to `root`.
    port : int, optional
        8888 by default, or another one if that is taken; one asked for must be free.
    config : Path, optional
        A folder with settings and layout to use in place of the user's own.

    Raises
    ------
    ServerError
        JupyterLab is missing or does not start, or the port asked for is taken.
    """
    if importlib.util.find_spec("jupyterlab") is None:
        raise ServerError(f"JupyterLab is not installed: {how_to_install('jupyter')}")
    chosen = _free_port([USUAL_PORT, 0] if port is None else [port])
    token = secrets.token_hex(24)
    environment = {**os.environ, "JUPYTER_TOKEN": token}
    if config is not None:
        environment["JUPYTER_CONFIG_DIR"] = str(config)
    process = subprocess.Popen(_command(root, chosen), env=environment)  # noqa: S603 - our own
    address = f"http://{HOST}:{chosen}/lab/tree/{quote(notebook.as_posix())}?token={token}"
    server = JupyterServer(process, address)
    try:
        _wait_for(server, f"http://{HOST}:{chosen}/api")
    except BaseException:  # Ctrl-C too: no server is left behind
        server.stop()
        raise
    return server


def trust(notebooks: Iterable[Path]) -> None:
    """Sign notebooks, as JupyterLab's command Trust Notebook does.

    What they hold then answers at once, before any cell is run: JupyterLab runs no script of a
    notebook that is not signed. Where nothing can be signed, the reader runs the cells first.
    """
    import nbformat
    from nbformat.sign import NotebookNotary

    try:
        notary = NotebookNotary()  # type: ignore[no-untyped-call]
        for path in notebooks:
            notary.sign(nbformat.read(path, as_version=4))  # type: ignore[no-untyped-call]
    except (OSError, sqlite3.Error):  # a home that cannot be written
        return


def _command(root: Path, port: int) -> list[str]:
    """Return the command line of a JupyterLab that says nothing but errors."""
    as_root = hasattr(os, "geteuid") and os.geteuid() == 0
    return [
        sys.executable,
        "-m",
        "jupyterlab",
        "--no-browser",
        f"--ServerApp.root_dir={root}",
        f"--ServerApp.ip={HOST}",
        f"--ServerApp.port={port}",
        "--ServerApp.port_retries=0",
        "--ServerApp.answer_yes=True",
        "--Application.log_level=ERROR",
        *(["--allow-root"] if as_root else []),
    ]


def _free_port(wanted: Sequence[int]) -> int:
    """Return the first port that can be used; 0 stands for any."""
    for port in wanted:
        with socket.socket() as tried:
            try:
                tried.bind((HOST, port))
            except OSError as error:
                reason = error.strerror
                continue
            return int(tried.getsockname()[1])
    raise ServerError(
        f"port {wanted[0]} cannot be used ({reason}); leave it out, and a free one is chosen"
    )


def _wait_for(server: JupyterServer, url: str) -> None:
    """Return when the server answers, or say that it does not."""
    # Without proxies: one that is set for the web would be asked for this machine's own address.
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    end = time.monotonic() + SECONDS_TO_START
    while time.monotonic() < end:
        if server.process.poll() is not None:
            raise ServerError("JupyterLab ended before it was ready; its own words stand above")
        try:
            with opener.open(url, timeout=2):
                return
        except (OSError, http.client.HTTPException):  # nobody answers yet
            time.sleep(0.1)
    raise ServerError(f"JupyterLab did not answer within {SECONDS_TO_START:g} s")
