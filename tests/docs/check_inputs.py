#!/usr/bin/env python3
"""check_inputs.py BIN_DIR SCRATCH: of documents written by hand, the program takes what their schema allows and refuses what
it forbids (exit code 3, naming the file). 77: no jsonschema."""
import copy
import json
import pathlib
import shutil
import sys

try:
    import jsonschema  # noqa: F401  (what schema_files needs)
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

from program import Program
from schema_files import validator_of

BALL = {"superellipsoid": {"radii_mm": [8, 8, 8]}}
SOLID = {"format": "isostack-solid", "version": 1,
         "solid": {"difference": [BALL, BALL | {"affine": [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]], "name": "bite"}]}}
LANDMARKS = {"format": "isostack-landmarks", "version": 1,
             "landmarks": [{"name": "tip", "from_mm": [0, 0, 0], "to_mm": [0, 0, 0]},
                           {"from_mm": [9, 2, 0], "to_mm": [9, 1, 0]}, {"from_mm": [1, 7, 0], "to_mm": [2, 7, 0]}]}
FEATURES = {"format": "isostack-features", "version": 1, "transitions": [],
            "features": [{"from": {"shape": 0, "vertex": 0}, "to": {"shape": 1, "vertex": 0}, "sharp": False}]}
RECIPE = {"format": "isostack-recipe", "version": 1, "command": "segment", "options": {"level": 25, "largest": True}}


def put(*path, value):
    """A change that puts the value at the place."""
    def change(document):
        for key in path[:-1]:
            document = document[key]
        document[path[-1]] = value
    return change


def drop(*path):
    def change(document):
        for key in path[:-1]:
            document = document[key]
        del document[path[-1]]
    return change


FIGURES = "morph shapes/x.png shapes/o.png --frames 2 --size 64 -o morph.png"
# Kind, a valid document, the command that reads document.json, and what must not pass.
DOCUMENTS = [
    ("solid", SOLID, "measure document.json",
     [put("version", value=2), drop("solid"), put("colour", value="red"), put("solid", "union", value=[BALL]),
      put("solid", "difference", value=[]), put("solid", "difference", 0, "superellipsoid", "radii_mm", value=[8, 0, 8]),
      put("solid", "difference", 0, "superellipsoid", "exponents", value=[3, 1]),
      put("solid", "difference", 1, "affine", value=[[1, 0, 0]]), put("solid", "difference", 1, "name", value=7)]),
    ("landmarks", LANDMARKS, FIGURES + " --landmarks document.json",
     [put("format", value="isostack-points"), drop("version"), put("landmarks", value=[]),
      drop("landmarks", 0, "to_mm"), put("landmarks", 1, "from_mm", value=[1, 2]),
      put("landmarks", 1, "from_mm", value=[1, 2, "3"])]),
    ("features", FEATURES, FIGURES + " --method subdivision --levels 2 --features document.json",
     [put("version", value="1"), put("features", value={}), drop("features", 0, "to"),
      put("features", 0, "from", "shape", value=-1), drop("features", 0, "from", "vertex"),
      put("features", 0, "sharp", value="yes"), put("features", 0, "by_way_of", value=[{"t": 0.5}]),
      put("transitions", value=[{"level": 1}]), put("warp", value=[[1, 2, 3]])]),
    ("recipe", RECIPE, "segment sample/series --recipe document.json -o contours.json",
     [put("version", value=0), drop("command"), put("command", value="info"), put("options", value=[]),
      put("options", "level", value={"at": 25}), put("options", "level", value=[[25]])]),
]


def check(program, kind, valid, command, changes):
    validator = validator_of(kind)
    file = program.folder / "document.json"

    def verdicts(document):
        file.write_text(json.dumps(document))
        code, _, err = program.run(command)
        assert code == 0 or (code == 3 and "document.json" in err), f"{kind}: exit code {code}: {err}"
        return code == 0, validator.is_valid(document), err

    takes, allows, err = verdicts(valid)
    assert takes and allows, f"{kind}: a right document is refused: {err}"
    for number, change in enumerate(changes):
        document = copy.deepcopy(valid)
        change(document)
        takes, allows, _ = verdicts(document)
        assert not allows, f"{kind}, change {number}: the schema lets it pass: {json.dumps(document)}"
        assert not takes, f"{kind}, change {number}: the program lets it pass: {json.dumps(document)}"


def main():
    scratch = pathlib.Path(sys.argv[2])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    program = Program(pathlib.Path(sys.argv[1]).resolve(), scratch)
    program.make("phantom", "sample")
    program.make("shapes", "shapes")
    for document in DOCUMENTS:
        check(program, *document)
    print("schemas and program agree on documents written by hand")


main()
