"""The real programs of a build, for tests of what they print."""
import json
import os
import shutil
import subprocess


class Program:
    def __init__(self, binaries, folder):
        self.binaries, self.folder = binaries, folder
        self.has_display = bool(os.environ.get("DISPLAY"))

    def make(self, generator, name):
        subprocess.run([self.binaries / f"isostack_make_{generator}", self.folder / name], check=True)

    def run(self, line, text=None):
        """One line as in a shell, in the folder, with the text as its standard input. Returns exit code, stdout, stderr."""
        done = subprocess.run([self.binaries / "isostack", *line.split()], cwd=self.folder, capture_output=True, text=True,
                              input=text)
        return done.returncode, done.stdout, done.stderr

    def result(self, line):
        code, out, err = self.run(line + " --json")
        assert code == 0, f"isostack {line}: exit code {code}: {err}"
        return json.loads(out)

    def failure(self, line, expected_code):
        code, out, err = self.run(line + " --json")
        assert code == expected_code, f"isostack {line}: exit code {code} instead of {expected_code}: {err}"
        return json.loads(out)

    def window_result(self, line):
        """Opens a window and closes it by its key; None without a display or xdotool."""
        if not self.has_display or not shutil.which("xdotool"):
            return None
        window = subprocess.Popen([self.binaries / "isostack", *line.split(), "--json", "--title", "to be closed"],
                                  cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        try:
            found = subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name", "isostack.*to be closed"],
                                   capture_output=True, text=True, timeout=60).stdout.split()
            while window.poll() is None:
                subprocess.run(["xdotool", "key", "--window", found[0], "q", "sleep", "0.3"], capture_output=True)
            return json.loads(window.stdout.read())
        finally:
            window.kill()
