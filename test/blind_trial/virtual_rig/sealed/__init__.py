# The laws of trial 2: sealed, so whoever writes candidates of the diagnosis does not open this folder. None of them has
# the form of a slider, a Prony series, a dead zone, a linear stop or a ramp; each names its source where there is one.
"""Sealed laws: `LAWS[effect]` as in virtual_rig/laws.py, with nothing in common but the format."""
from . import elastic, loops, memory, on_rig, unlisted  # noqa: F401  (each registers its laws)
from .registry import LAWS

EFFECTS = tuple(k for k in LAWS if not k.startswith("unknown:"))
UNKNOWN = tuple(k for k in LAWS if k.startswith("unknown:"))
