"""The examples of docs/python.md run, in their order, in one folder with the phantom in sample/."""

import contextlib
import io
import os
import pathlib
import re
import unittest

from support import SCRATCH, main, phantom, run

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"

try:
    import vtk
except ImportError:
    vtk = None


class Examples(unittest.TestCase):
    def test_all(self):
        phantom()
        os.chdir(SCRATCH)
        names = {}
        examples = re.findall(r"^```python\n(.*?)^```", DOCUMENT.read_text(), re.S | re.M)
        self.assertGreater(len(examples), 10)
        for example in examples:
            if "isostack.vtk" in example and vtk is None:
                continue
            with self.subTest(example.splitlines()[0]), contextlib.redirect_stdout(io.StringIO()):
                exec(compile(example, str(DOCUMENT), "exec"), names)
        self.assertTrue(names["measures"].watertight)
        self.assertGreater(names["difference"].dice, 0.98)
        run("reconstruct", "sample/series", "--level", 25, "-o", "by_command.stl")
        self.assertEqual(pathlib.Path("organ.stl").read_bytes(), pathlib.Path("by_command.stl").read_bytes())
        self.assertLessEqual(len(examples[0].strip().splitlines()), 10)


if __name__ == "__main__":
    main()
