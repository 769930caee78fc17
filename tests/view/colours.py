"""How well colours are told apart: by their lightness, and by people who lack a kind of cone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Colour = tuple[int, ...]

CONES = {
    "deutan": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413),
               (-0.011820, 0.042940, 0.968881)),
    "protan": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216),
               (-0.003882, -0.048116, 1.051998)),
}  # fmt: skip
"""What people without green, or without red, cones see of linear red, green and blue: Machado,
Oliveira and Fernandes, A physiologically-based model for simulation of color vision deficiency
(2009), severity 1."""

LEAST_DIFFERENCE = 10.0
"""CIE 1976 colour difference: four times what is just noticed, 2.3."""

XYZ_OF_RGB = ((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505))
WHITE = (0.9505, 1.0, 1.089)


def linear(colour: Colour) -> NDArray[np.float64]:
    """Return red, green and blue, 0 to 255, as parts of the light."""
    parts = np.array(colour) / 255
    return np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)


def contrast(a: Colour, b: Colour) -> float:
    """Return the contrast ratio of two colours as WCAG 2.2 defines it, 1 to 21."""
    dark, light = sorted(float(np.dot(XYZ_OF_RGB[1], linear(colour))) for colour in (a, b))
    return (light + 0.05) / (dark + 0.05)


def difference(a: Colour, b: Colour, cones: str) -> float:
    """Return how different two colours are to somebody with these cones, in CIE L*a*b*."""
    return float(np.linalg.norm(_seen(a, cones) - _seen(b, cones)))


def _seen(colour: Colour, cones: str) -> NDArray[np.float64]:
    light = np.clip(np.array(CONES[cones]) @ linear(colour), 0, 1)
    x, y, z = np.array(XYZ_OF_RGB) @ light / WHITE
    f, g, h = (np.cbrt(t) if t > 0.008856 else 7.787 * t + 16 / 116 for t in (x, y, z))
    return np.array([116 * g - 16, 500 * (f - g), 200 * (g - h)])
