#!/usr/bin/python3
"""Checks that pages name existing files, commands and launch files, that pages and comments use the words of the field,
that messages name existing options, and that docs/api.md names the public headers.

Usage: documents.py FOLDER_OF_THE_PACKAGE. Prints a line per violation; exit status 1 if there is any.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

LARGEST_PICTURE = 150_000  # bytes; every clone contains all versions of all pictures
# Words that this package invented, and the words that the field uses.
FOREIGN = {
    "specimen": "component, or test piece", "own parameter": "model parameter", "yardstick": "baseline, or reference",
    "foresee": "predict", "in vain": "false positive", "hasten": "accelerate", "anew": "again", "lets go": "resumes",
    "bear out": "confirm", "goes on": "continues",
}
LONGEST_PAGE = 150  # lines of a page in docs/ that was written by hand
LONGEST_TOUR = 120  # lines of README.md
GENERATED = {"commands.md", "parameters.md", "topics.md", "effects.md"}
WRITTEN = {"augmented.yaml", "augmented_full.yaml", "components.yaml", "surrogate.yaml"}  # by a diagnosis, by a user
# These words have a plain meaning in comments.
PLAIN_IN_COMMENTS = {"own parameter"}
OTHER_PROGRAMS = re.compile(r"\b(squeue|sbatch|SBATCH)\b")
FENCE = re.compile(r"^```(\w*)[^\n]*\n(.*?)^```$", re.M | re.S)


def pages(root):
    """Return the Markdown pages of the package by path, except installed copies and builds."""
    found = [*root.glob("*.md"), *root.glob("docs/*.md"), *root.glob("config/**/*.md"), *root.glob("test/*/*.md")]
    return {path: path.read_text(encoding="utf-8") for path in sorted(found)}


def anchors(text):
    """Return the anchors that GitHub generates from the headings."""
    titles = re.findall(r"^#+ (.*)$", FENCE.sub("", text), re.M)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def link_violations(root, path, text):
    for target in re.findall(r"\]\(([^)\s]+)\)", FENCE.sub("", text)):
        if re.match(r"\w+:", target):
            continue
        name, _, anchor = target.partition("#")
        file = path.parent / name if name else path
        if not file.exists():
            yield f"link to {target}, which does not exist"
        elif anchor and anchor not in anchors(file.read_text(encoding="utf-8")):
            yield f"link to {target}, but {file.relative_to(root)} has no such heading"


def length_violations(root):
    """Check that pages are short enough to be read in a few minutes."""
    limits = {path: LONGEST_PAGE for path in (root / "docs").glob("*.md") if path.name not in GENERATED}
    for path, limit in sorted({**limits, root / "README.md": LONGEST_TOUR}.items()):
        length = len(path.read_text(encoding="utf-8").splitlines())
        if length > limit:
            yield f"{path.relative_to(root)}: {length} lines, more than {limit}"


def options(root):
    """Return the options of each command from docs/commands.md, which is compared with the printed help."""
    sections = re.split(r"^## (\w+)$", (root / "docs/commands.md").read_text(encoding="utf-8"), flags=re.M)[1:]
    return {name: set(re.findall(r"--[\w-]+", text)) for name, text in zip(sections[::2], sections[1::2])}


def command_violations(text, known):
    """Check options and arguments of the command lines on a page, in fenced blocks and in the text."""
    inline = re.findall(r"`(ros(?:run|launch)[^`]+)`", FENCE.sub("", text))
    lines = [line for _, block in FENCE.findall(text) for line in block.replace("\\\n", " ").splitlines()]
    for line in [*lines, *inline]:
        run = re.search(r"rosrun rubber_suspension (\w+)(.*)", line)
        if run and run[1] in known["options"]:
            for option in re.findall(r"(?<!\S)--[\w-]+", run[2].split(" #")[0]):
                if option not in known["options"][run[1]]:
                    yield f"{run[1]} has no option {option}"
        launch = re.search(r"roslaunch .*?rubber_suspension (\w+\.launch)(.*)", line)
        if launch and launch[1] not in known["arguments"]:
            yield f"there is no {launch[1]}"
        elif launch:
            for argument in re.findall(r"(\w+):=", launch[2]):
                if argument not in known["arguments"][launch[1]]:
                    yield f"{launch[1]} has no argument {argument}"
    every_argument = set().union(*known["arguments"].values())
    for argument in re.findall(r"`(\w+):=", FENCE.sub("", text)):
        if argument not in every_argument:
            yield f"no launch file has an argument {argument}"


def sources(root):
    """Return all files that a page may name."""
    folders = ("src", "include", "test", "launch", "msg", "config", "scripts")
    return ["/" + str(path.relative_to(root)) for folder in folders for path in (root / folder).rglob("*.*")]


def source_violations(text, known):
    """Check the names of files in the text, with or without their folders."""
    for name in re.findall(r"`([\w/]+\.(?:cpp|h|py|launch|msg|yaml))`", FENCE.sub("", text)):
        placeholder = re.match(r"(?:.*/)?(?:x[._]|[A-Z])", name)
        if not placeholder and name not in WRITTEN and not any(file.endswith("/" + name) for file in known["sources"]):
            yield f"names {name}, which does not exist"


def word_violations(text):
    for word, instead in FOREIGN.items():
        if re.search(rf"\b{word}", text, re.I):
            yield f"says '{word}'; the field says: {instead}"


def comment_violations(text):
    """Check the words in the comments of a source."""
    comments = "\n".join(line.split("//", 1)[1] for line in text.splitlines() if "//" in line)
    for word, instead in FOREIGN.items():
        if word not in PLAIN_IN_COMMENTS and re.search(rf"\b{word}", comments, re.I):
            yield f"says '{word}'; the field says: {instead}"


def message_violations(path, text, known):
    """Check that messages name only options of the commands that print them, as far as the folder determines these."""
    folder, name = path.parts[1], path.stem
    every = set().union(*known.values())
    reading = set.intersection(*(options for options in known.values() if "--columns" in options))
    accepted = {"log": reading, "bag": reading, "diagnosis": known["diagnose"], "campaign": known["campaign"],
                "apps": known.get(name, every)}.get(folder, every)
    code = re.sub(r"^\s*//.*", "", text, flags=re.M)
    for literal in re.findall(r'"((?:[^"\\\n]|\\.)*)"', code):
        if not OTHER_PROGRAMS.search(literal):
            for option in sorted(set(re.findall(r"(?<![\w-])--[a-z][\w-]*", literal)) - accepted):
                yield f"a message names {option}, which is no option there: \"{literal[:60]}\""


def header_violations(root):
    """Check that each public header has a row in docs/api.md that states its use, and that no row is obsolete."""
    public = {str(path.relative_to(root / "include/rubber_suspension")) for path in (root / "include").rglob("*.h")}
    text = (root / "docs/api.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`[\w/]+\.h`.*?) \|(.*)\|$", text, re.M)
    named = [name for names, _ in rows for name in re.findall(r"`([\w/]+\.h)`", names)]
    yield from (f"does not name {name}" for name in sorted(public - set(named)))
    yield from (f"names {name}, which is no public header" for name in sorted(set(named) - public))
    yield from (f"names {name} in {named.count(name)} rows" for name in sorted(set(named)) if named.count(name) > 1)
    yield from (f"does not say what {names} is for" for names, use in rows if not use.strip())


def main(root):
    known = {"options": options(root), "sources": sources(root),
             "arguments": {path.name: {arg.get("name") for arg in ElementTree.parse(path).getroot().findall("arg")}
                           for path in (root / "launch").glob("*.launch")}}
    found = []
    for path, text in pages(root).items():
        for violation in (*link_violations(root, path, text), *command_violations(text, known),
                          *source_violations(text, known), *word_violations(text)):
            found.append(f"{path.relative_to(root)}: {violation}")
    for path in [*(root / "launch").glob("*.launch"), *(root / "config").rglob("*.yaml"), root / "CHANGELOG.rst"]:
        found += [f"{path.relative_to(root)}: {v}" for v in word_violations(path.read_text(encoding="utf-8"))]
    for path in sorted(path for folder in ("src", "include") for path in (root / folder).rglob("*.[hc]*")):
        text, name = path.read_text(encoding="utf-8"), path.relative_to(root)
        found += [f"{name}: {v}" for v in (*comment_violations(text), *message_violations(name, text, known["options"]))]
    found += length_violations(root)
    found += [f"docs/api.md: {violation}" for violation in header_violations(root)]
    for path in (root / "docs/images").iterdir():
        if path.stat().st_size > LARGEST_PICTURE:
            size = path.stat().st_size
            found.append(f"{path.relative_to(root)}: {size} bytes, more than {LARGEST_PICTURE}; try pngquant")
    if not known["options"] or not known["arguments"]:
        found.append("no commands or no launch files found")
    print("\n".join(found), end="\n" if found else "")
    return found


if __name__ == "__main__":
    sys.exit(1 if main(pathlib.Path(sys.argv[1]).resolve()) else 0)
