#!/usr/bin/env python3
"""check_options.py BIN_DIR: every option of every command is told of in docs/*.md, the options that examples there use exist, the
generated pages (manual, Markdown) have them all, and program, sources, changelog and package agree about the version."""
import os
import pathlib
import re
import subprocess
import sys

PROGRAM = pathlib.Path(sys.argv[1]).absolute() / "isostack"
TOP = pathlib.Path(__file__).resolve().parents[2]
OPTION = re.compile(r"--[a-z][a-z-]*[a-z]")


def printed(*arguments):
    return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout


def options_of_commands():
    """From the help, which CLI11 writes: the generated pages are compared with it."""
    commands = re.findall(r"^  (\w+)  ", printed("--help").partition("Subcommands:")[2], re.MULTILINE)
    assert len(commands) >= 8, commands
    help_of = {"": printed("--help").partition("Subcommands:")[0]} | {name: printed(name, "--help") for name in commands}
    return {name: set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.MULTILINE)) | set(re.findall(r"^  (?:-\w,)?--[a-z-]+,(--[a-z-]+)", text, re.MULTILINE))
            for name, text in help_of.items()}


def sections(page):
    """Markdown under each heading of the second order."""
    parts = re.split(r"^## (.+)$", page, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2]))


def told_of(command, written):
    """Options that a command's sections in commands.md name, with the pages and sections of other commands that they refer to."""
    commands = written["commands.md"]
    if not command:
        return set(OPTION.findall(commands))
    own = "\n".join(text for heading, text in sections(commands).items() if heading.split()[0] == command)
    referred = [written[page] for page in re.findall(r"\]\(([a-z-]+\.md)", own)]
    referred += [text for heading, text in sections(commands).items() if f"`{heading}`" in own]
    return set(OPTION.findall("\n".join([own, *referred])))


def check_pages(options):
    written = {file.name: file.read_text() for file in (TOP / "docs").glob("*.md")}
    generated, manual = sections(printed("--generate", "markdown")), printed("--generate", "man").replace("\\-", "-")
    problems = []
    for command, names in options.items():
        assert "--help" in names or not command
        page, told = generated[command or "All commands"], told_of(command, written) | {"--help", "--version", "--output"}
        for name in sorted(names):
            if name not in told:
                problems.append(f"docs/commands.md and the pages it links to say nothing of {name} of `{command}`")
            if f"`{name}`" not in page:
                problems.append(f"{name} of `{command}` is missing on the page of all options")
            if name not in manual:
                problems.append(f"{name} of `{command}` is missing in the manual page")
        problems += [f"an option of `{command}` has no description: {line}" for line in re.findall(r"^\|.*\|  \|$", page, re.MULTILINE)]
    return problems


def check_examples(options):
    """Of lines that call the program, alone in their lines."""
    problems = []
    for file in [*(TOP / "docs").glob("*.md"), TOP / "README.md", TOP / "sample_data/README.md"]:
        for command, rest in re.findall(r"^(?: {4}|)(?:\$ )?(?:xvfb-run (?:-a )?)?(?:\$bin/)?isostack (\w+) ([^#|\n]*)", file.read_text(), re.MULTILINE):
            if command in options:
                problems += [f"{file.name}: `isostack {command}` has no {name}" for name in OPTION.findall(rest)
                             if name not in options[command] | options[""]]
    return problems


def check_version():
    version = re.search(r"project\(isostack VERSION (\S+)", (TOP / "CMakeLists.txt").read_text())[1]
    newest = re.search(r"^## \[([0-9.]+)\] - \d{4}-\d{2}-\d{2}$", (TOP / "CHANGELOG.md").read_text(), re.MULTILINE)
    build = PROGRAM.parents[1]
    said = {
        "isostack --version": printed("--version").strip(),
        "manual page": re.search(r'"isostack (\S+)"', printed("--generate", "man"))[1],
        "page of all options": re.search(r"Of isostack (\S+),", printed("--generate", "markdown"))[1],
        "newest release in CHANGELOG.md": newest and newest[1],
    }
    config = build / "isostack-config-version.cmake"
    package = build / "CPackConfig.cmake"
    if config.exists():
        said["find_package(isostack)"] = re.search(r'PACKAGE_VERSION "(\S+)"', config.read_text())[1]
        said["Debian packages"] = re.search(r'CPACK_PACKAGE_VERSION "(\S+)"', package.read_text())[1]
    if list((build / "python/isostack").glob("_core*.so")):
        environment = os.environ | {"PYTHONPATH": str(build / "python")}
        said["Python module"] = subprocess.run([sys.executable, "-c", "import isostack; print(isostack.__version__)"],
                                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment).stdout.strip()
    problems = [f"{what} says version {other}, CMakeLists.txt {version}" for what, other in said.items() if other != version]
    stray = [str(file.relative_to(TOP)) for pattern in ("cmake/**/*", "python/**/*.py", "python/**/*.toml", "cli/**/*", "docs/mkdocs*")
             for file in TOP.glob(pattern) if file.is_file() and re.search(rf"(?<![\d.]){re.escape(version)}(?![\d.])", file.read_text(errors="ignore"))]
    return problems + [f"{file} repeats the version, which is CMakeLists.txt's to say" for file in stray]


OPTIONS = options_of_commands()
found = check_pages(OPTIONS) + check_examples(OPTIONS) + check_version()
if found:
    sys.exit("\n".join(found))
print(f"{sum(map(len, OPTIONS.values()))} options of {len(OPTIONS) - 1} commands are documented")
