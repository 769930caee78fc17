"""Accuracy against time: the cost of each method for the accuracy that it gives.

=============  ============================================================
module         what it holds
=============  ============================================================
``scenes``     seven scenes with known answers, and the norm of the error
``methods``    the methods and the settings that each is tried at
``counting``   work that does not depend on the machine
``measure``    errors, work and times of all points
``result``     the results, and conclusions from them
=============  ============================================================
"""

from lesson_code.evidence.orders import Fit, fit_order
from lesson_code.evidence.work_precision.measure import measure_accuracy
from lesson_code.evidence.work_precision.result import (
    Point,
    WorkPrecision,
    cheapest,
    in_words,
    order_of,
    orders,
    splits,
)
from lesson_code.evidence.work_precision.scenes import PrecisionScene, scenes

stored = WorkPrecision.stored

__all__ = [
    "Fit",
    "Point",
    "PrecisionScene",
    "WorkPrecision",
    "cheapest",
    "fit_order",
    "in_words",
    "measure_accuracy",
    "order_of",
    "orders",
    "scenes",
    "splits",
    "stored",
]
