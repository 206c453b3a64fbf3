#!/usr/bin/env python3
"""run_tutorial.py BIN_DIR SCRATCH: follows docs/tutorial.md word by word. Every `sh` block is run; what it prints is what the
`text` block behind it shows, numbers to 2 % (they end differently on other processors), seconds aside. A block that
imports isostack is left out where Python has no such module. SCRATCH may be the folder of an installed program's user, BIN_DIR its /usr/bin."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
UID_OR_TIME = re.compile(r"\d+(?:\.\d+){3,}|[\d.]+ s\b")


def agree(shown, printed):
    """Line by line: the same words, numbers that differ by no more than 2 % or two units of the last digit."""
    shown, printed = (UID_OR_TIME.sub("?", line).rstrip() for line in (shown, printed))
    if NUMBER.sub("#", shown) != NUMBER.sub("#", printed):
        return False
    for ours, theirs in zip(NUMBER.findall(shown), NUMBER.findall(printed)):
        digits = len(ours.partition(".")[2])
        allowed = max(0.02 * abs(float(ours)), 2 * 10.0**-digits if digits else 0)
        if abs(float(ours) - float(theirs)) > allowed:
            return False
    return True


def require_printed(expected, printed, block):
    ours, theirs = expected.splitlines(), printed.splitlines()
    if len(ours) == len(theirs) and all(map(agree, ours, theirs)):
        return
    sys.exit(f"docs/tutorial.md: this printed something else than it shows:\n{block}\nshown:\n{expected}\nprinted:\n{printed}")


class Shell:
    """One after the other, in the folder that the block before ended in."""

    def __init__(self, binaries, folder):
        self.folder = folder
        self.environment = os.environ | {"PATH": f"{binaries}:/usr/bin:{os.environ['PATH']}"}

    def run(self, block):
        if "DISPLAY" in os.environ:
            block = block.replace("xvfb-run -a ", "")  # a screen is there
        where = self.folder / ".where"
        done = subprocess.run(["bash", "-c", f"set -e\n{block}\npwd >{where}"], cwd=self.folder, env=self.environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            sys.exit(f"docs/tutorial.md: exit code {done.returncode}:\n{block}\n{done.stdout}")
        self.folder = pathlib.Path(where.read_text().strip())
        where.unlink()
        return done.stdout

    def has_module(self):
        return not subprocess.run(["python3", "-c", "import isostack"], env=self.environment, capture_output=True).returncode


def main():
    scratch = pathlib.Path(sys.argv[2]).absolute()
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    shell = Shell(pathlib.Path(sys.argv[1]).absolute(), scratch)
    tutorial = pathlib.Path(__file__).resolve().parents[2] / "docs/tutorial.md"
    blocks = FENCE.findall(tutorial.read_text())
    count = 0
    for number, (kind, text) in enumerate(blocks):
        if kind != "sh":
            continue  # installing; what was shown
        if "import isostack" in text and not shell.has_module():
            print("no Python module: its lines are left out")
            continue
        printed = shell.run(text)
        if number + 1 < len(blocks) and blocks[number + 1][0] == "text":
            require_printed(blocks[number + 1][1], printed, text)
        count += 1
    for picture in re.findall(r"\]\((images/[^)]+)\)", tutorial.read_text()):
        assert (tutorial.parent / picture).exists(), picture
    assert count > 8, count
    print(f"{count} steps of the tutorial came out as it says")


main()
