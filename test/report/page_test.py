#!/usr/bin/python3
"""Runs `diagnose` on the shipped example and checks the page: its source and, if headless Chromium is installed, its
look at 1200 x 900, at 400 px, in the dark scheme and on paper.

Usage: page_test.py FOLDER_OF_THE_PROGRAMS EXAMPLE OUTPUT. Pictures and print are written to OUTPUT. The exit status is
77 if Chromium is missing and all other checks pass.
"""
import csv
import html.parser
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import browser

PROGRAMS, EXAMPLE, OUTPUT = (os.path.abspath(argument) for argument in sys.argv[1:4])
LARGEST = 400_000  # bytes of a page about six logs
# Elements that exceed the width of a page. Parts of drawings are excluded, because a drawing scales as a whole.
TOO_WIDE = """
Array.from(document.body.querySelectorAll(':not(svg *)')).filter(e => {
  const box = e.getBoundingClientRect();
  return box.width > 0 && (box.right > innerWidth + 0.5 || box.left < -0.5 || e.scrollWidth > e.clientWidth + 1
    && getComputedStyle(e).display != 'inline' && e.clientWidth > 0);
}).map(e => e.tagName + '.' + e.className + ': ' + e.textContent.slice(0, 60))
"""
# Texts of the first screen that overlap each other or exceed their containers.
OVERLAPS = """
(() => {
  const texts = [], wrong = [];
  const walker = document.createTreeWalker(document.querySelector('.first'), NodeFilter.SHOW_TEXT);
  for (let node; node = walker.nextNode();) {
    if (!node.data.trim() || node.parentElement.closest('svg')) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    const holder = node.parentElement.closest('td, th, .row > span, p, dd, dt, h3, caption, figcaption');
    for (const box of range.getClientRects()) {
      if (box.width > 0) texts.push({node, box, holder});
    }
  }
  for (const {node, box, holder} of texts) {
    const within = holder.getBoundingClientRect();
    if (box.left < within.left - 1 || box.right > within.right + 1 || box.top < within.top - 2 || box.bottom > within.bottom + 2)
      wrong.push('cut: ' + node.data);
  }
  for (let i = 0; i < texts.length; ++i) {
    for (let j = i + 1; j < texts.length; ++j) {
      const a = texts[i].box, b = texts[j].box;
      if (texts[i].node != texts[j].node && Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1
          && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 3)
        wrong.push('over each other: ' + texts[i].node.data + ' | ' + texts[j].node.data);
    }
  }
  return wrong;
})()
"""
# Colour and pattern of the parts of the first bar, which shows the configured gap.
FILLS = """
Array.from(document.querySelectorAll('.keys i')).map(e => [getComputedStyle(e).backgroundColor,
  getComputedStyle(e).backgroundImage])
"""
# Contrast between each visible text and its background, by WCAG 2.
LOW_CONTRAST = """
(() => {
  const rgb = text => text.match(/[\\d.]+/g).map(Number);
  const linear = c => (c /= 255, c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  const luminance = c => 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
  const behind = e => {
    for (; e; e = e.parentElement) {
      const c = rgb(getComputedStyle(e).backgroundColor);
      if (c.length < 4 || c[3] > 0) return c;
    }
    return [255, 255, 255];
  };
  const ratio = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  const low = [];
  for (const e of document.body.querySelectorAll('*')) {
    const own = Array.from(e.childNodes).some(n => n.nodeType == 3 && n.data.trim());
    if (!own || !e.getClientRects().length) continue;
    const style = getComputedStyle(e);
    const colour = e.closest('svg') ? (style.fill == 'none' ? style.color : style.fill) : style.color;
    const found = ratio(luminance(rgb(colour)), luminance(behind(e)));
    if (found < 4.5) low.push(e.tagName + ' ' + e.textContent.slice(0, 40) + ': ' + found.toFixed(2));
  }
  return low;
})()
"""


def diagnose(folder, logs, hold_out, *options):
    path = os.path.join(OUTPUT, folder)
    environment = dict(os.environ, SOURCE_DATE_EPOCH="1700000000")
    command = [os.path.join(PROGRAMS, "diagnose"), "--config", os.path.join(EXAMPLE, "component.yaml"), "--log", *logs]
    command += ["--hold-out", *hold_out] if hold_out else []
    subprocess.run([*command, *options, "--output", path], check=True, env=environment, stdout=subprocess.DEVNULL)
    return path


def example(kind):
    names = sorted(name for name in os.listdir(EXAMPLE) if name.startswith(kind) and name.endswith(".csv"))
    return [os.path.join(EXAMPLE, name) for name in names]


def reversed_log():
    """Write a log of the example with a reversed sign of the force, which must lead to the verdict `check_bench`."""
    path = os.path.join(OUTPUT, "reversed.csv")
    with open(example("log_")[0], encoding="utf-8") as source, open(path, "w", encoding="utf-8") as target:
        header = source.readline()
        column = [name.split("_")[0] for name in header.strip().split(",")].index("force")
        target.write(header)
        for line in source:
            fields = line.strip().split(",")
            fields[column] = repr(-float(fields[column]))
            target.write(",".join(fields) + "\n")
    return path


def open_question():
    """Write the first 200 lines of a log of the example, in which little happens."""
    path = os.path.join(OUTPUT, "open.csv")
    with open(example("log_")[1], encoding="utf-8") as source, open(path, "w", encoding="utf-8") as target:
        target.writelines(source.readlines()[:200])
    return path


def shortened_log():
    """Write a log of the example without its last sample, because the same log twice would be refused."""
    path = os.path.join(OUTPUT, "shortened.csv")
    with open(example("log_")[0], encoding="utf-8") as source, open(path, "w", encoding="utf-8") as target:
        target.writelines(source.readlines()[:-1])
    return path


class Outline(html.parser.HTMLParser):
    """Collects tags and links of a page."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.links, self.untitled = [], [], 0
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        attributes = dict(attributes)
        self.links += [value for name, value in attributes.items() if name in ("href", "src", "xlink:href") and value]
        self.untitled += tag == "td" and "data-title" not in attributes


class Reports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        os.makedirs(OUTPUT, exist_ok=True)
        cls.folder = diagnose("example", example("log_"), example("hold_out_") + [shortened_log()])  # six logs
        cls.bench = diagnose("check_bench", [reversed_log()], [])
        cls.pages = [os.path.join(folder, "report.html") for folder in (cls.folder, cls.bench)]

    def text(self, page):
        with open(page, encoding="utf-8") as file:
            return file.read()


class WithoutBrowser(Reports):
    def test_size_and_independence(self):
        for page in self.pages:
            text = self.text(page)
            self.assertLess(len(text.encode()), LARGEST)
            outline = Outline(text)
            self.assertNotIn("script", outline.tags)
            self.assertEqual(outline.untitled, 0)
            for link in outline.links:  # links within the page, or to a file of the report
                self.assertTrue(link.startswith(("#", "data:image/")) or os.path.isfile(os.path.join(os.path.dirname(page), link)), link)
            self.assertNotRegex(text, r"(?<![\w.])-?(nan|inf)(?![\w.])")

    def test_pictures_come_before_the_first_section(self):
        text = self.text(self.pages[0])
        first = text[:text.index("<h2>")]
        for title in ("Where", "Which, and how far", "How sure"):
            self.assertIn("<h3>%s</h3>" % title, first)
        self.assertEqual(first.count(" largest\""), 2)  # one before and one after the augmentation
        headline = re.search("<h1>(.*?)</h1>", text).group(1)
        self.assertLessEqual(len(headline.split()), 25, headline)

    def test_a_bench_to_be_checked_is_seen(self):
        """The page shows the loops as recorded and as corrected, drawn and as numbers."""
        text = self.text(self.pages[1])
        self.assertEqual(text.count("<svg"), 2)
        self.assertLess(text.index("<svg"), text.index("<h2>"))
        with open(os.path.join(self.bench, "figure_bench.csv"), encoding="utf-8") as file:
            panels = {row["panel"]: row["curve"] for row in csv.DictReader(file)}
        self.assertEqual(len(panels), 2)
        self.assertTrue(any("force times -1" in panel for panel in panels), panels)

    def test_record_of_the_run(self):
        with open(os.path.join(self.folder, "report.json"), encoding="utf-8") as file:
            report = json.load(file)
        self.assertEqual(report["meta"]["date"], "2023-11-14T22:13:20Z")
        self.assertEqual(len(report["meta"]["files"]), 7)
        self.assertIn("diagnose --config", report["meta"]["command_line"])
        for file in report["meta"]["files"]:
            self.assertIn(file["sha256"], self.text(self.pages[0]))
        for size in report["model_sizes"] + report["effect_sizes"]:
            low, high = size["interval_95"]
            self.assertTrue(low <= size["value"] <= high, size)

    # The checks follow the layout of RPC III: records of 128 bytes, numbers of four bytes.
    def check_drive_file(self, folder):
        with open(os.path.join(folder, "next_experiment.drv"), "rb") as file:
            data = file.read()
        records = [data[i:i + 128] for i in range(0, 512, 128)]
        blocks = int(records[1][32:].rstrip(b"\0"))
        header = {data[i:i + 32].rstrip(b"\0").decode(): data[i + 32:i + 128].rstrip(b"\0").decode()
                  for i in range(0, 512 * blocks, 128)}
        self.assertEqual((header["FORMAT"], header["FILE_TYPE"], header["DATA_TYPE"], header["CHANNELS"]),
                         ("BINARY_IEEE_LITTLE_END", "TIME_HISTORY", "FLOATING_POINT", "1"))
        self.assertEqual(header["UNITS.CHAN_1"], "mm")
        count = int(header["FRAMES"]) * int(header["PTS_PER_FRAME"])
        drive = struct.unpack(f"<{count}f", data[512 * blocks:])
        with open(os.path.join(folder, "next_experiment.csv"), encoding="utf-8") as file:
            rows = [[float(cell) for cell in row] for row in list(csv.reader(file))[1:]]
        self.assertAlmostEqual(float(header["DELTA_T"]), rows[1][0] - rows[0][0], 8)
        largest = max(abs(row[1]) for row in rows)
        self.assertLess(max(abs(1e-3 * z - row[1]) for z, row in zip(drive, rows)), 1e-6 * largest)
        self.assertEqual(set(drive[len(rows):]), {drive[len(rows) - 1]})

    def test_next_experiment_can_be_replayed(self):
        folder = diagnose("open", [open_question()], [], "--limits", "stroke=10 mm", "speed=0.5 m/s", "frequency=30 Hz",
                          "force=30 kN", "duration=60 s")
        with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
            name = json.load(file)["next_experiment_log"]
        subprocess.run([os.path.join(PROGRAMS, "replay"), "--config", os.path.join(folder, "augmented.yaml"), "--log",
                        os.path.join(folder, name), "--output", os.path.join(OUTPUT, "played.csv")], check=True,
                       stdout=subprocess.DEVNULL)
        self.check_drive_file(folder)

    def test_the_same_run_gives_the_same_files(self):
        def files(folder):
            return {path.name: path.read_bytes() for path in sorted(pathlib.Path(folder).iterdir())}

        before = files(self.folder)
        diagnose("example", example("log_"), example("hold_out_") + [shortened_log()])
        after = files(self.folder)
        self.assertEqual(list(before), list(after))
        for name, content in before.items():
            self.assertEqual(content, after[name], name)


@unittest.skipUnless(browser.chromium(), "Chromium is not installed: no page is looked at")
class InChromium(Reports):
    def test_screens(self):
        for page in self.pages:
            with browser.Page(page) as shown:
                name = os.path.join(OUTPUT, os.path.basename(os.path.dirname(page)))
                for width, dark in ((1200, False), (1200, True), (400, False)):
                    shown.show(width, 900, dark)
                    shown.picture("%s_%d%s.png" % (name, width, "_dark" if dark else ""), whole=width == 400)
                    self.assertEqual(shown.evaluate(TOO_WIDE), [], "at %d px" % width)
                    self.assertEqual(shown.evaluate(OVERLAPS), [], "at %d px" % width)
                    self.assertEqual(shown.evaluate(LOW_CONTRAST), [], "dark" if dark else "light")

    def test_first_screen_holds_the_pictures(self):
        with browser.Page(self.pages[0]) as page:
            page.show(1200, 900)
            bottoms = page.evaluate(
                "Array.from(document.querySelectorAll('.picture')).map(e => e.getBoundingClientRect().bottom)")
            self.assertEqual(len(bottoms), 3)
            self.assertLess(max(bottoms), 900)

    def test_patterns_tell_without_colours(self):
        with browser.Page(self.pages[0]) as page:
            page.show(1200, 900)
            fills = page.evaluate(FILLS)
            self.assertGreater(len(fills), 2)  # values, an effect, and the residual force
            patterns = [re.sub(r"rgb\([^)]*\)", "", image) for _, image in fills]
            self.assertEqual(len(set(patterns)), len(patterns), patterns)

    def test_overlaps_would_be_found(self):
        with browser.Page(self.pages[0]) as page:
            page.show(400, 900)
            page.evaluate("document.querySelector('.map td.largest').style.cssText = 'font-size: 60px'")
            self.assertNotEqual(page.evaluate(OVERLAPS), [])

    def test_print_is_two_pages_of_a4(self):
        with browser.Page(self.pages[0]) as page:
            page.show(1200, 900)
            data = page.pdf(os.path.join(OUTPUT, "example.pdf"))
            self.assertLessEqual(len(re.findall(rb"/Type\s*/Page\b", data)), 2)
            boxes = re.findall(rb"/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)", data)
            self.assertTrue(boxes)
            for width, height in boxes:  # 210 mm x 297 mm in points
                self.assertAlmostEqual(float(width), 595.3, delta=1.5)
                self.assertAlmostEqual(float(height), 841.9, delta=1.5)


if __name__ == "__main__":
    result = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    sys.exit(1 if not result.wasSuccessful() else 77 if result.skipped else 0)
