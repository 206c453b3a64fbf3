"""Stubs and module agree, everything has a docstring, and mypy takes correct calls and refuses wrong ones."""

import ast
import importlib.util
import inspect
import os
import pathlib
import subprocess
import sys
import unittest

import isostack
from support import SCRATCH, main

PACKAGE = pathlib.Path(isostack.__file__).parent

GOOD = """
import isostack

images: isostack.SliceStack = isostack.read_slices("series", series="2")
organ = isostack.segment(images[::2], level=226.0)
result = isostack.reconstruct(organ, isostack.ReconstructOptions(kernel="biharmonic", caps="flat"), smoothing=1)
volume: float = isostack.compare(result.surface, result.surface).volume_difference_mm3
points = result.surface.vertices_mm[:, 2].mean()
rules = isostack.OrganRules(seeds=[(1.0, 2.0, 3.0, "liver")], start=["grow:2"])
frames = isostack.morph([organ[0], organ[1]]).frames(5)
try:
    isostack.write(result, "organ.stl")
except isostack.InputError as error:
    print(error.remedy)
"""
BAD = """
import isostack

isostack.ReconstructOptions(smothing=1)
isostack.reconstruct("organ")
isostack.read_mesh("a.stl").vertices
"""


class Stubs(unittest.TestCase):
    def test_every_name_and_every_option_is_in_them(self):
        tree = ast.parse((PACKAGE / "_core.pyi").read_text())
        classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
        public = {name for name in vars(isostack._core) if not name.startswith("_")}
        self.assertEqual(classes.keys() | functions, public)
        for name, node in classes.items():
            kind = getattr(isostack, name)
            if not hasattr(kind, "__signature__"):
                continue
            constructor = next(part for part in node.body if getattr(part, "name", "") == "__init__")
            self.assertEqual([a.arg for a in constructor.args.kwonlyargs], list(kind.__signature__.parameters), name)
        self.assertTrue((PACKAGE / "py.typed").exists())

    @unittest.skipIf(importlib.util.find_spec("mypy") is None, "mypy is absent")
    def test_mypy(self):
        (SCRATCH / "good.py").write_text(GOOD)
        (SCRATCH / "bad.py").write_text(BAD)

        def check(name):
            return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", SCRATCH / "mypy",
                                   SCRATCH / name], env=os.environ | {"MYPYPATH": str(PACKAGE.parent)},
                                  capture_output=True, text=True).stdout

        self.assertIn("Success", check("good.py"))
        found = check("bad.py")
        for complaint in ['"smothing"', '"str"; expected "ContourStack"', 'no attribute "vertices"']:
            self.assertIn(complaint, found)


class Docstrings(unittest.TestCase):
    def test_everything_says_what_it_is(self):
        silent = []
        for name, value in vars(isostack).items():
            if name.startswith("_") or inspect.ismodule(value):
                continue
            if not (inspect.getdoc(value) or "").strip():
                silent.append(name)
            if not isinstance(value, type) or hasattr(value, "__members__"):
                continue
            for field, member in vars(value).items():
                if isinstance(member, property) and not field.startswith("_") and not (member.__doc__ or "").strip():
                    silent.append(f"{name}.{field}")
        self.assertEqual(silent, [])

    def test_verbs_show_their_parameters(self):
        for name in ("read", "segment", "reconstruct", "morph", "measure", "compare", "write", "convert"):
            self.assertTrue(inspect.signature(getattr(isostack, name)).parameters, name)


if __name__ == "__main__":
    main()
