#!/usr/bin/python3
"""Runs the commands of pages and compares their output and pictures with those of the pages.

Usage: pages.py ROOT PROGRAMS PAGE... [--write]. Prints a line per difference; exit status 1 if there is any.
In a page (CONTRIBUTING.md):
- The blocks ```sh run are one script, which begins in the folder of the package; /tmp is a temporary folder.
- A block ```yaml to FILE is the content of FILE for the commands after it.
- A block ```text after a script shows its output on stdout, with long lines wrapped; ```text 2 shows two lines of it.
- A picture with <!-- of FILE --> after it shows FILE from the script. For FILE.html it is the first screen in Chromium.
Text is compared exactly, except for line breaks and spaces. --write updates output and pictures.
roslaunch needs the environment of the build, as `catkin_generated/env_cached.sh` provides it.
"""

import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import textwrap

import numpy
from PIL import Image

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "report"))

import browser  # noqa: E402

WIDTH = 120  # characters per line of a page
COLOURS = 128  # few colours, because every clone contains all versions of all pictures
# Mean difference of two pictures, relative to the range of brightness. A smaller number of colours causes 0.005,
# another curve or line of text more than 0.01.
SAME_PICTURE = 0.01
FENCE = re.compile(r"^( *)```(sh run|yaml to \S+|text(?: \d+)?)\n(.*?)^ *```$", re.M | re.S)
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)]+)\)<!-- of ([^ ]+) -->")
PRELUDE = """set -e
rosrun() {{ shift; local name=$1; shift; if [ -x "{scripts}/$name" ]; then "{scripts}/$name" "$@"; else "{programs}/$name" "$@"; fi; }}
cd "{root}"
"""


class Page:
    """A page, and a run of its commands."""

    def __init__(self, root, path, programs):
        self.root, self.path, self.programs = root, path, programs
        self.text = path.read_text(encoding="utf-8")
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="pages."))
        self.blocks = list(FENCE.finditer(self.text))
        self.outputs = {}  # printed lines by the index of the block that shows them

    def here(self, text):
        """Return a text of the page with the folder of this run instead of /tmp."""
        return text.replace("/tmp/", f"{self.folder}/")

    def run(self):
        """Run all commands in one shell, and store the output that each block shows."""
        script = PRELUDE.format(root=self.root, programs=self.programs, scripts=self.root / "scripts")
        last = None  # index of the last block of commands
        for i, (kind, content) in enumerate((block[2], self.here(textwrap.dedent(block[3]))) for block in self.blocks):
            if kind == "sh run":
                last = i
                script += "{ " + content + "\n} > " + f'"{self.folder}/output.{i}"\n'
            elif kind.startswith("yaml to "):
                script += f"cat > '{self.here(kind[8:])}' <<'END_OF_FILE'\n{content}END_OF_FILE\n"
            elif last is None:
                raise RuntimeError("a block of output stands before any block ```sh run")
            else:
                self.outputs[i] = last
        with socket.socket() as one:
            one.bind(("127.0.0.1", 0))
            master = f"http://127.0.0.1:{one.getsockname()[1]}"
        done = subprocess.run(["bash", "-c", script], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, check=False,
                              env={**os.environ, "ROS_MASTER_URI": master, "PYTHONUNBUFFERED": "1"})
        if done.returncode != 0:
            last = done.stderr.strip().splitlines()[-5:] or ["no message"]
            raise RuntimeError(f"the commands end with status {done.returncode}: " + " | ".join(last))
        for i, last in self.outputs.items():
            lines = (self.folder / f"output.{last}").read_text(encoding="utf-8")
            lines = lines.replace(f"{self.folder}/", "/tmp/").splitlines()
            count = self.blocks[i][2].partition(" ")[2]
            self.outputs[i] = lines[:int(count)] if count else lines

    def differences(self):
        """Yield the differences between the page and what its commands print and draw."""
        for i, lines in self.outputs.items():
            shown, printed = " ".join(self.blocks[i][3].split()), " ".join(" ".join(lines).split())
            if shown != printed:
                yield f"shows '{shown}', but prints '{printed}'"
        for picture, file in PICTURE.findall(self.text):
            drawn = self.picture(file)
            if drawn is not None and difference(self.path.parent / picture, drawn) > SAME_PICTURE:
                yield f"{picture} is not what {file} is now"

    def write(self):
        """Update the page and its pictures."""
        text, end = "", 0
        for i, block in enumerate(self.blocks):
            text += self.text[end:block.start()]
            text += wrapped(self.outputs[i], block) if i in self.outputs else block[0]
            end = block.end()
        self.path.write_text(text + self.text[end:], encoding="utf-8")
        for picture, file in PICTURE.findall(self.text):
            drawn, old = self.picture(file), self.path.parent / picture
            if drawn is not None and difference(old, drawn) > SAME_PICTURE:
                Image.open(drawn).convert("RGB").quantize(COLOURS).save(old, optimize=True)

    def picture(self, file):
        """Return the file that a picture shows, or None if a browser is needed but not installed."""
        path = pathlib.Path(self.here(file))
        if path.suffix != ".html":
            return path
        if browser.chromium() is None:
            print(f"{self.path.relative_to(self.root)}: no Chromium: the picture of {file} is not compared")
            return None
        drawn = path.with_suffix(".png")
        with browser.Page(path) as page:
            page.show(1100, 760)
            page.picture(drawn)
        return drawn


def wrapped(lines, block):
    """Return a block of output, wrapped to the width and indentation of the page."""
    indent = block[1]
    rows = [row for line in lines for row in textwrap.wrap(line, WIDTH - len(indent), subsequent_indent="",
                                                           break_long_words=False, break_on_hyphens=False) or [""]]
    return "\n".join([f"{indent}```{block[2]}", *((indent + row).rstrip() for row in rows), f"{indent}```"])


def difference(one, other):
    """Return the mean difference in brightness of two pictures, or 1 if their sizes differ or one is missing."""
    if not one.exists() or not other.exists():
        return 1.0
    pictures = [numpy.asarray(Image.open(path).convert("RGB"), dtype=float) / 255.0 for path in (one, other)]
    return 1.0 if pictures[0].shape != pictures[1].shape else float(numpy.abs(pictures[0] - pictures[1]).mean())


def problems(root, name, programs, write):
    """Return the differences of a page, one per line."""
    page = Page(root, root / name, programs)
    try:
        page.run()
        found = list(page.differences())
        if write:
            page.write()
        return found
    except RuntimeError as failure:
        return [str(failure)]
    finally:
        shutil.rmtree(page.folder)


def main(root, programs, names, write):
    wrong = 0
    for name in names:
        found = problems(root, name, programs, write)
        if found and not write and "roslaunch" in (root / name).read_text(encoding="utf-8"):
            print(f"{name}: {found[0]}; once more, since it plays in real time on a machine that may be busy")
            found = problems(root, name, programs, write)
        wrong += len(found)
        for line in found:
            print(f"{name}: {line}")
    return 0 if write or wrong == 0 else 1


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--write"]
    sys.exit(main(pathlib.Path(words[0]).resolve(), pathlib.Path(words[1]).resolve(), words[2:], "--write" in sys.argv))
