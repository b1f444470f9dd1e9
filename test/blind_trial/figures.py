# Figures of a trial: rates with their intervals, medians, how true stated probabilities are, and how tables show them.
# Every figure is a dict that JSON can hold.
"""Figures that trials are scored by."""
import math

import numpy as np


def rate(flags):
    """{hits, of, rate, interval_95} with Wilson's interval."""
    flags = [bool(f) for f in flags]
    n, k = len(flags), sum(flags)
    if n == 0:
        return {"hits": 0, "of": 0, "rate": None, "interval_95": None}
    z, p = 1.96, k / n
    middle = (p + z * z / (2 * n)) / (1 + z * z / n)
    half = z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n)) / (1 + z * z / n)
    return {"hits": k, "of": n, "rate": p, "interval_95": [max(0.0, middle - half), min(1.0, middle + half)]}


def number(values):
    """{value: median, of: count}."""
    values = [v for v in values if v is not None]
    return {"value": float(np.median(values)) if values else None, "of": len(values)}


def calibration_error(pairs):
    """Expected calibration error of pairs (stated probability, whether it was so), ten bins."""
    pairs = [(p, hit) for p, hit in pairs if p is not None]
    if not pairs:
        return {"value": None, "of": 0, "bins": []}
    bins, error = [], 0.0
    for low in np.arange(10) / 10.0:
        inside = [(p, hit) for p, hit in pairs if low <= p < low + 0.1 or (p >= 1.0 and low > 0.85)]
        if inside:
            mean, hits = float(np.mean([p for p, _ in inside])), float(np.mean([h for _, h in inside]))
            bins.append({"probability": mean, "right": hits, "of": len(inside)})
            error += abs(mean - hits) * len(inside) / len(pairs)
    return {"value": error, "of": len(pairs), "bins": bins}


def text(figure):
    """A figure in a cell of a table."""
    if "rate" in figure:
        if figure["rate"] is None:
            return "-"
        low, high = figure["interval_95"]
        return f"{100 * figure['rate']:.0f} % ({figure['hits']}/{figure['of']}, {100 * low:.0f} to {100 * high:.0f} %)"
    return "-" if figure["value"] is None else f"{figure['value']:.3f} (of {figure['of']})"


def met(figure, goal, larger):
    value = figure.get("rate", figure.get("value"))
    if goal is None or value is None:
        return ""
    return "yes" if (value >= goal if larger else value <= goal) else "no"
