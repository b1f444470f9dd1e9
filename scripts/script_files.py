"""Writes files for the scripts of the package: never replaces a file of another kind, never leaves a partial file."""

import contextlib
import itertools
import json
import os
import subprocess

FIGURES = (b"\x89PNG", b"<?xml", b"<svg", b"%PDF")  # first bytes of figures


def check_outputs(outputs, force):
    """Checks output files as the commands do. `outputs` has an option, a path and the first bytes of its kind for each
    file. Raises ValueError for two outputs in one file, for a folder, and for a file of another kind unless `force`."""
    for (one, path, _), (other, second, _) in itertools.combinations(outputs, 2):
        if os.path.realpath(path).lower() == os.path.realpath(second).lower():
            raise ValueError("%s and %s: both write %s; accepted: a separate file for each" % (one, other, second))
    for option, path, beginnings in outputs:
        if os.path.isdir(path):
            raise ValueError("%s: %s is a folder; accepted: a file" % (option, path))
        if not force and os.path.isfile(path) and os.path.getsize(path) > 0:
            with open(path, "rb") as file:
                if not file.read(64).startswith(beginnings):
                    raise ValueError("%s: %s exists and is of another kind; accepted: another name, or --force" % (option, path))


@contextlib.contextmanager
def beside(path):
    """Yields the name of a temporary file beside `path`, which replaces `path` at the end and is removed on errors."""
    target = os.path.realpath(path)
    if os.path.exists(target) and not os.path.isfile(target):
        yield target  # a device
        return
    stem, extension = os.path.splitext(os.path.basename(target))
    unfinished = os.path.join(os.path.dirname(target), ".%s.%d%s" % (stem, os.getpid(), extension))
    try:
        open(unfinished, "wb").close()
        yield unfinished
        os.replace(unfinished, target)
    finally:
        if os.path.exists(unfinished):
            os.remove(unfinished)


def draw(path, figure):
    """Draws a figure, with the fields of include/rubber_suspension/io/figure.h, by plot_figures. Raises ValueError."""
    if not path.endswith((".svg", ".png")):
        raise ValueError("%s: is not the name of a figure; accepted: a name that ends in .svg or .png" % path)
    script = os.path.join(os.path.dirname(os.path.realpath(__file__)), "plot_figures")
    request = json.dumps({"path": path, "figure": figure})
    drawn = subprocess.run([script], input=request, text=True, stderr=subprocess.PIPE)
    if drawn.returncode != 0:
        raise ValueError("the figure was not drawn: " + (drawn.stderr.strip().splitlines() or ["the script was ended"])[-1])
