"""Elements of an SVG as text: what every drawing of this folder and of a chapter is made of."""

from __future__ import annotations

from html import escape


def element(tag: str, *content: str, **attributes: object) -> str:
    """Return an element around some content, or one that stands alone if there is none.

    Parameters
    ----------
    tag : str
        Its name.
    *content : str
        Elements, or words that are escaped already.
    **attributes : object
        In their order, None left out. An underscore stands for a hyphen; one at the end is dropped.

    Examples
    --------
    >>> element("g", element("circle", r=2), class_="b", stroke_width=None, fill="#fff")
    '<g class="b" fill="#fff"><circle r="2"/></g>'
    """
    given = "".join(
        f' {name.rstrip("_").replace("_", "-")}="{escape(str(value))}"'
        for name, value in attributes.items()
        if value is not None
    )
    return f"<{tag}{given}>{''.join(content)}</{tag}>" if content else f"<{tag}{given}/>"


def hatching(name: str, size: int, *content: str) -> str:
    """Return a pattern of slanting lines that a fill can name, from one square of it."""
    return element(
        "defs",
        element(
            "pattern",
            *content,
            id=name,
            width=size,
            height=size,
            patternUnits="userSpaceOnUse",
            patternTransform="rotate(45)",
        ),
    )
