#!/usr/bin/env python3
"""check_schemas.py BIN_DIR SCRATCH: what the program writes is valid by its schemas, wrong documents are not. 77: no jsonschema."""
import copy
import json
import pathlib
import shutil
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

binaries, scratch = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
docs = pathlib.Path(__file__).resolve().parents[2] / "docs"


def schema(name):
    result = json.loads((docs / name).read_text())
    jsonschema.Draft202012Validator.check_schema(result)
    return jsonschema.Draft202012Validator(result)


def run(*arguments):
    return subprocess.run([binaries / "isostack", *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def expect_invalid(validator, document, change):
    """`change` spoils a copy of a valid document."""
    wrong = copy.deepcopy(document)
    change(wrong)
    assert not validator.is_valid(wrong), f"a wrong document passed: {json.dumps(wrong)[:400]}"


def check_pipeline():
    contours, surface, pipeline = (scratch / n for n in ("contours.json", "organ.stl", "pipeline.json"))
    run("segment", scratch / "sample/series", "--level", 25, "--largest", "-o", contours, "--record", pipeline)
    run("reconstruct", contours, "--max-constraints", 500, "--resolution", 4, "-o", surface, "--record", pipeline)
    validator, document = schema("pipeline.schema.json"), json.loads(pipeline.read_text())
    validator.validate(document)
    assert len(document["steps"]) == 2
    expect_invalid(validator, document, lambda d: d.update(version=2))
    expect_invalid(validator, document, lambda d: d.update(colour="red"))
    expect_invalid(validator, document, lambda d: d["steps"][0].pop("command"))
    expect_invalid(validator, document, lambda d: d["steps"][0].update(command="fly"))
    expect_invalid(validator, document, lambda d: d["steps"][0]["options"].update(level={"at": 25}))
    expect_invalid(validator, document, lambda d: d["inputs"]["series"].update(sha256="short"))


def check_contours():
    validator, document = schema("contours.schema.json"), json.loads((scratch / "contours.json").read_text())
    validator.validate(document)
    expect_invalid(validator, document, lambda d: d.pop("organs"))
    expect_invalid(validator, document, lambda d: d["organs"][0]["slices"][0]["pose"].update(x_axis=[1, 0]))


shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)
subprocess.run([binaries / "isostack_make_phantom", scratch / "sample"], check=True)
check_pipeline()
check_contours()
print("schemas agree")
