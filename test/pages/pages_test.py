#!/usr/bin/python3
"""Tests of pages.py with generated pages. Run in this folder: python3 -m unittest pages_test"""
import contextlib
import io
import pathlib
import tempfile
import unittest

import numpy
from PIL import Image

import pages

PAGE = """# A page

```sh run
echo "gap 0.2 %%, 31.4 N, in /tmp/report"; echo second
```

- In a list:

  ```text 1
  gap %s, in /tmp/report
  ```

```yaml to /tmp/a.yaml
a: 1
```

```sh run
cat /tmp/a.yaml
```

```text
a: 1
```
"""


class Pages(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name)

    def main(self, text, write=False):
        """Return exit status and output for a package with one page."""
        (self.root / "page.md").write_text(text, encoding="utf-8")
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            status = pages.main(self.root, self.root, ["page.md"], write)
        return status, said.getvalue()

    def test_what_is_printed_passes(self):
        self.assertEqual(self.main(PAGE % "0.2 %, 31.4 N"), (0, ""))

    def test_another_number_or_word_is_told(self):
        for other in ("0.2 %, 31.3 N", "0.4 %, 31.4 N", "0.2 %, 31.4 m"):
            status, said = self.main(PAGE % other)
            self.assertEqual(status, 1)
            self.assertIn(f"shows 'gap {other}, in /tmp/report', but prints 'gap 0.2 %, 31.4 N, in /tmp/report'", said)

    def test_what_is_printed_is_written_at_its_place(self):
        self.main(PAGE % "3 %", write=True)
        self.assertEqual((self.root / "page.md").read_text(encoding="utf-8"), PAGE % "0.2 %, 31.4 N")

    def test_commands_that_fail_are_told(self):
        status, said = self.main("```sh run\necho no such log >&2; false\n```\n")
        self.assertEqual((status, said), (1, "page.md: the commands end with status 1: no such log\n"))

    def test_pictures_are_compared_and_written(self):
        for name, grey in (("old.png", 100), ("new.png", 150)):
            Image.fromarray(numpy.full((20, 30, 3), grey, dtype=numpy.uint8)).save(self.root / name)
        page = "```sh run\ncp new.png /tmp/new.png\n```\n![old](old.png)<!-- of /tmp/new.png -->\n"
        self.assertEqual(self.main(page), (1, "page.md: old.png is not what /tmp/new.png is now\n"))
        self.main(page, write=True)
        self.assertEqual(self.main(page), (0, ""))


if __name__ == "__main__":
    unittest.main()
