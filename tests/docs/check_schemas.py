#!/usr/bin/env python3
"""check_schemas.py BIN_DIR SCRATCH: what the program writes is valid by its schemas, wrong documents are not. 77: no jsonschema."""
import json
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

try:
    import jsonschema  # noqa: F401
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

import results
import schema_files
from program import Program

scratch = pathlib.Path(sys.argv[2]).absolute()
program = Program(pathlib.Path(sys.argv[1]).absolute(), scratch)
VALIDATORS = {name: schema_files.validator_of(name) for name in schema_files.SCHEMAS}
seen = {}  # one valid document per schema and set of keys


def require_valid(name, document, what):
    errors = [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:300]}" for e in VALIDATORS[name].iter_errors(document)]
    assert not errors, f"{what} is not valid by {name}.schema.json: {errors}"
    seen.setdefault(name, {}).setdefault(keys_of(document), document)


def keys_of(document):
    if isinstance(document, dict):
        return tuple((key, keys_of(value)) for key, value in sorted(document.items()))
    return keys_of(document[0]) if isinstance(document, list) and document else ()


def require_invalid(name, document, what):
    assert not VALIDATORS[name].is_valid(document), f"{name}.schema.json lets this pass: {what}: {json.dumps(document)[:400]}"


def check_results():
    forms = [results.SEGMENT, results.RECONSTRUCT, results.INFO, results.MEASURE, results.CONVERT, results.MORPH]
    shared = (pathlib.Path(__file__).resolve().parents[2] / results.SHARED).resolve()
    if shared.is_dir():
        forms.append(results.SHARED_FORMS.replace("{shared}", str(shared)))
    if program.has_display:
        forms.append(results.VIEW)
    for line in [line for form in forms for line in results.lines(form)]:
        document = program.result(line)
        require_valid(line.split()[0], document, f"isostack {line}")
        assert "isostack" in document
    window = program.window_result(results.WINDOW)
    if window:
        require_valid("view", window, "a window")


def check_runs():
    program.run("segment sample/series --level 25 --largest -o run.json --record pipeline.json --report report.json")
    program.run("reconstruct run.json --max-constraints 300 --resolution 6 -o run.stl --record pipeline.json")
    program.run("measure run.stl --record pipeline.json")
    program.run("info run.stl --record pipeline.json")
    require_valid("segment", json.loads((scratch / "report.json").read_text()), "--report")
    require_valid("pipeline", json.loads((scratch / "pipeline.json").read_text()), "pipeline.json")
    states = set()
    for line in results.lines(results.RUN):
        document = program.result(line)
        require_valid("run", document, f"isostack {line}")
        states.update(step["state"] for step in document.get("steps", []))
    assert states == {"ran", "kept", "would run"}, states


def check_batch():
    code, out, err = program.run("batch", results.BATCH)
    assert code == 0, err
    printed = [json.loads(line) for line in out.splitlines()]
    for document in printed:
        require_valid("batch", document, "a line of isostack batch")
    assert [document["exit_code"] for document in printed] == [0, 3], out


def check_failures():
    for code, kind, line in results.FAILURES:
        document = program.failure(line, code)
        require_valid("error", document, f"isostack {line}")
        assert (document["error"]["exit_code"], document["error"]["kind"]) == (code, kind), document
    stopped = subprocess.Popen([program.binaries / "isostack", "reconstruct", "organ.json", "--kernel", "auto", "-o", "stopped.stl", "--json"],
                               cwd=scratch, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    while stopped.poll() is None and not catches_interrupts(stopped.pid):
        time.sleep(0.01)
    stopped.send_signal(signal.SIGINT)
    out, _ = stopped.communicate()
    assert stopped.returncode == 5, stopped.returncode
    require_valid("error", json.loads(out), "a cancelled command")


def catches_interrupts(pid):
    caught = re.search(r"^SigCgt:\s*(\w+)", pathlib.Path(f"/proc/{pid}/status").read_text(), re.MULTILINE)[1]
    return bool(int(caught, 16) >> (signal.SIGINT - 1) & 1)


def check_files():
    require_valid("contours", json.loads((scratch / "organ.json").read_text()), "organ.json")
    session = {"format": "isostack-view", "version": 1, "inputs": ["organ.vtp"], "state": {"plane": 3, "seeds": [{"position_mm": [1, 2, 3]}]}}
    require_valid("view-session", session, "a session")


def check_wrong_documents():
    """Members that readers ignore, options of commands and inputs of pipelines may have any name. Each change is tried once for
    each schema."""
    open_to_more = {"contours", "view-session"}
    in_options = lambda path: len(path) > 3 and path[2] in ("options", "defaults")
    refused = set()
    for name, documents in seen.items():
        for document in documents.values():
            for what, wrong in schema_files.spoilt(name, document, in_options if name == "pipeline" else lambda path: False):
                is_allowed = "unknown" in what and (name in open_to_more or what.endswith(("/options'", "/defaults'", "'inputs'")))
                if not is_allowed and what != "no 'inputs/series'" and (name, what) not in refused:
                    require_invalid(name, wrong, what)
                    refused.add((name, what))
    return len(refused)


def check_wrong_values():
    """Numbers beyond what their units allow, words that are not among the known, places with two coordinates, ..."""
    for name, path, value in results.WRONG_VALUES:
        documents = [d for d in seen[name].values() if has(d, path)]
        assert documents or not program.has_display, f"no valid document of {name} has {path}"
        for document in documents:
            require_invalid(name, schema_files.changed(document, path, schema_files.put(value)), f"{path} = {value}")


def has(document, path):
    try:
        schema_files.value_at(document, path)
        return True
    except (KeyError, IndexError, TypeError):
        return False


shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)
for generator, folder in (("phantom", "sample"), ("shapes", "shapes"), ("key_shapes", "keys")):
    program.make(generator, folder)
(scratch / "ball.json").write_text(json.dumps(results.BALL))
for preparation in results.lines(results.PREPARE):
    program.result(preparation)
for check in (check_files, check_runs, check_results, check_batch, check_failures):
    check()
written_by_hand = {"solid", "landmarks", "features", "recipe"}  # check_inputs.py
unseen = set(schema_files.SCHEMAS) - {"common"} - written_by_hand - set(seen)
assert not program.has_display or not unseen, f"no document of {unseen} was made"
count = check_wrong_documents()
check_wrong_values()
print(f"schemas agree with {sum(map(len, seen.values()))} documents and refuse {count} wrong ones")
