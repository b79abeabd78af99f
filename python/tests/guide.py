#!/usr/bin/python3
"""outside: every block of docs/scripting.md runs, one after the other, and prints what stands below it; so do the examples in docstrings."""
import contextlib
import doctest
import importlib
import io
import json
import os
import pathlib
import pkgutil
import re
import shutil
import tempfile
import unittest

os.environ["MPLBACKEND"] = "Agg"
import flexslip  # noqa: E402
from package import SOURCE  # noqa: E402

BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:```text\n(.*?)^```\n)?", re.MULTILINE | re.DOTALL)


class Guide(unittest.TestCase):
    maxDiff = 4000

    def test_outside_every_block_prints_what_it_says(self):
        page = (SOURCE / "docs/scripting.md").read_text(encoding="utf-8")
        blocks = BLOCK.findall(page)
        self.assertEqual(len(blocks), page.count("```python\n"))
        self.assertGreater(len(blocks), 10)
        names = {"__name__": "__main__"}
        self.addCleanup(os.chdir, SOURCE)
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(SOURCE / "examples", pathlib.Path(folder) / "examples")
            os.chdir(folder)
            for code, printed in blocks:
                out = io.StringIO()
                with contextlib.redirect_stdout(out):
                    exec(compile(code, "docs/scripting.md", "exec"), names)
                with self.subTest(code):
                    self.assertEqual(out.getvalue(), printed)
            os.chdir(SOURCE)


class Notebooks(unittest.TestCase):
    def test_outside_the_cells_of_every_notebook_run_in_order(self):
        os.environ["FLEXSLIP_ROOT"] = str(SOURCE)
        self.addCleanup(os.chdir, SOURCE)
        paths = sorted((SOURCE / "docs/notebooks").glob("*.ipynb"))
        self.assertGreater(len(paths), 3)
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            for path in paths:
                names = {"__name__": "__main__"}
                for number, cell in enumerate(json.loads(path.read_text(encoding="utf-8"))["cells"]):
                    if cell["cell_type"] == "code":
                        with self.subTest(path.stem, cell=number), contextlib.redirect_stdout(io.StringIO()):
                            exec(compile("".join(cell["source"]), f"{path.name}, cell {number}", "exec"), names)
            os.chdir(SOURCE)


class Docstrings(unittest.TestCase):
    def test_outside_examples_in_docstrings(self):
        os.chdir(SOURCE)
        tried = 0
        for module in pkgutil.iter_modules(flexslip.__path__):
            if module.name.startswith("_flexslip"):
                continue
            results = doctest.testmod(importlib.import_module(f"flexslip.{module.name}"))
            tried += results.attempted
            self.assertEqual(results.failed, 0, module.name)
        self.assertEqual(doctest.testmod(flexslip).failed, 0)
        self.assertGreater(tried, 30)

    def test_outside_everything_public_says_what_it_is(self):
        self.assertLessEqual(len(flexslip.__all__), 25)
        self.assertLessEqual({name for name in flexslip.__all__ if name[0].isupper()}, {*flexslip.types.__all__})
        for name in {*flexslip.__all__, *flexslip.types.__all__}:
            thing = getattr(flexslip, name)
            self.assertTrue(thing.__doc__ and len(thing.__doc__) > 10, name)
            if not isinstance(thing, type):
                self.assertIn("Examples", thing.__doc__, name)
                continue
            for attribute, member in vars(thing).items():
                if not attribute.startswith("_") and (callable(member) or isinstance(member, property)):
                    self.assertTrue(member.__doc__, f"{name}.{attribute}")


if __name__ == "__main__":
    unittest.main()
