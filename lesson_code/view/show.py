"""Figures in a notebook: shown once, with a text for those who do not see them."""

from __future__ import annotations

import io

from IPython.display import display
from matplotlib.figure import Figure


def png_of(figure: Figure) -> bytes:
    """Return a figure as the bytes of a PNG."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", metadata={"Software": None})
    return buffer.getvalue()


def show(figure: Figure, alt: str) -> None:
    """Display a figure below the cell.

    Parameters
    ----------
    figure : Figure
        What to show.
    alt : str
        What can be seen in it, in a sentence or two, for readers who cannot.

    Raises
    ------
    ValueError
        `alt` is empty.
    """
    if not alt.strip():
        raise ValueError("alt must say what the figure shows, got nothing")
    display(  # type: ignore[no-untyped-call]
        {"image/png": png_of(figure), "text/plain": f"Figure: {alt}"},
        metadata={"image/png": {"alt": alt}},
        raw=True,
    )
