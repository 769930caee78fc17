"""The loop of CONTRIBUTING in environments of its own: ``nox -s lint types tests``."""

import nox

nox.options.reuse_existing_virtualenvs = True


@nox.session
def lint(session: nox.Session) -> None:
    """Hold the code to its style and its layers, and derived files to their sources."""
    _install(session)
    session.run("ruff", "check", ".")
    session.run("ruff", "format", "--check", ".")
    session.run("lint-imports")
    session.run("workbook", "regenerate", "--check")


@nox.session
def types(session: nox.Session) -> None:
    """Check the types."""
    _install(session)
    session.run("mypy")


@nox.session
def tests(session: nox.Session) -> None:
    """Run the tests: those that are named behind ``--``, or all."""
    _install(session)
    session.run("pytest", "-n", "2", "--dist", "loadfile", *session.posargs)


def _install(session: nox.Session) -> None:
    """Install the project with what its tests need."""
    session.install("-q", "-c", "requirements.lock", "-e", ".[test]")
