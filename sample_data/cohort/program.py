"""The isostack program, started once for many commands."""
import ctypes
import json
import os
import shutil
import signal
import subprocess


def end_with_parent():
    """In the new process: a killed job leaves nothing behind that still writes."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG


class Stopped(Exception):
    """The command was ended from outside; nobody knows what it would have said."""


class Failure(Exception):
    def __init__(self, step, exit_code, message):
        super().__init__(message)
        self.result = {"status": "failed", "step": step, "exit_code": exit_code, "message": message}


def start_screen():
    """A screen to draw on where there is none; it takes a free number by itself, so that jobs do not meet."""
    reading, writing = os.pipe()
    screen = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
                              pass_fds=[writing], stderr=subprocess.DEVNULL, preexec_fn=end_with_parent)
    os.close(writing)
    with os.fdopen(reading) as number:
        os.environ["DISPLAY"] = ":" + number.readline().strip()
    return screen


class Program:
    """`isostack batch`: every command is a process of its own, without the time a new program takes to start."""

    def __init__(self, path, display=False):
        wants_screen = display and not os.environ.get("DISPLAY") and shutil.which("Xvfb")
        self.screen = start_screen() if wants_screen else None
        self.process = subprocess.Popen([path, "batch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                        preexec_fn=end_with_parent)

    def run(self, *words):
        """What the command did; Failure with its message, Stopped when it was killed."""
        try:
            self.process.stdin.write(json.dumps([str(word) for word in words]) + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            raise Stopped from None
        line = self.process.stdout.readline()
        if not line:
            raise Stopped
        done = json.loads(line)
        code = done["exit_code"]
        if code in (5, 130, 137, 143):
            raise Stopped
        if code != 0:
            lines = done["stderr"].strip().splitlines()
            raise Failure(words[0], code, lines[-1].removeprefix("isostack: ") if lines else f"the program died (signal {code - 128})")
        return done

    def close(self):
        self.process.stdin.close()
        self.process.wait()
        if self.screen:
            self.screen.terminate()
            self.screen.wait()
