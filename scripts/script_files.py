"""How the scripts of the package write files: nothing of another kind is replaced, nothing is left half-written."""

import contextlib
import itertools
import json
import os
import subprocess

FIGURES = (b"\x89PNG", b"<?xml", b"<svg", b"%PDF")  # how files of this kind begin


def check_outputs(outputs, force):
    """The rule of the other commands. `outputs` has an option, a path and the beginnings of its kind of file for each;
    raises ValueError for two that are one file, for a folder, and for a file of another kind unless `force`."""
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
    """A name beside the path to write to; the file takes the path when it is complete, or goes."""
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
    """Draw a figure, with the fields of include/rubber_suspension/io/figure.h, by plot_figures. Raises ValueError."""
    if not path.endswith((".svg", ".png")):
        raise ValueError("%s: is not the name of a figure; accepted: a name that ends in .svg or .png" % path)
    script = os.path.join(os.path.dirname(os.path.realpath(__file__)), "plot_figures")
    request = json.dumps({"path": path, "figure": figure})
    drawn = subprocess.run([script], input=request, text=True, stderr=subprocess.PIPE)
    if drawn.returncode != 0:
        raise ValueError("the figure was not drawn: " + (drawn.stderr.strip().splitlines() or ["the script was ended"])[-1])
