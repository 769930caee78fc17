"""Figures in a notebook: shown once, with a text for those who do not see them."""

from __future__ import annotations

import html
import io

from IPython.display import display
from matplotlib.figure import Figure


def png_of(figure: Figure) -> bytes:
    """Return a figure as the bytes of a PNG."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", metadata={"Software": None})
    return buffer.getvalue()


UNSEEN = "position:absolute; width:1px; height:1px; overflow:hidden; clip-path:inset(50%)"
"""Style that hides a text from view, but not from a screen reader."""


def show(figure: Figure, alt: str) -> None:
    """Display a figure below the cell, and its text where a screen reader finds it.

    JupyterLab gives the pictures of outputs no alternative text of their own; other viewers
    take it from the picture's metadata.

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
    hidden = f'<p style="{UNSEEN}">Figure: {html.escape(alt)}</p>'
    display({"text/html": hidden, "text/plain": f"Figure: {alt}"}, raw=True)  # type: ignore[no-untyped-call]
