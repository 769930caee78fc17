"""Accuracy against time: what each method costs for the accuracy that it gives.

=============  ============================================================
module         what it holds
=============  ============================================================
``scenes``     seven scenes with known answers, and the norm of the error
``methods``    the methods and the settings that each is tried at
``counting``   work that does not depend on the machine
``measure``    errors, work and times of all points
``result``     what was measured, as JSON, stored in the package too
``orders``     orders of convergence, splits of sweeps, the cheapest method
``tables``     the result as tables for the terminal
=============  ============================================================
"""

from lesson_code.evidence.work_precision.measure import measure_accuracy
from lesson_code.evidence.work_precision.orders import (
    Fit,
    cheapest,
    fit_order,
    in_words,
    order_of,
    orders,
    splits,
)
from lesson_code.evidence.work_precision.result import STORED, Point, WorkPrecision, store, stored
from lesson_code.evidence.work_precision.scenes import PrecisionScene, scenes

__all__ = [
    "STORED",
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
    "store",
    "stored",
]
