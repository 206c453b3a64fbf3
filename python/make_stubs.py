#!/usr/bin/env python3
"""make_stubs.py FILE: the types of the compiled module, from its signatures, as _core.pyi. Run by the build, with
PYTHONPATH leading to the package."""

import inspect
import re
import sys
import textwrap
from typing import Any, Iterator, List, NamedTuple, Tuple

HEADER = '''"""The compiled part of isostack: import isostack, which has all of it."""

import os
from typing import Any, Callable, ClassVar, Dict, Iterable, Iterator, List, Optional, Sequence, Tuple, Union, overload

import numpy
from numpy.typing import ArrayLike

__version__: str
'''

RENAMED = [
    (r"isostack\._core\.", ""),
    (r"numpy\.ndarray\[[^\]]*\[[^\]]*\](, flags\.[a-z_.]+)*\]", "numpy.ndarray"),
    (r"os\.PathLike", "Union[str, os.PathLike[str]]"),
    (r"std::function<.*>", "Callable[[List[KeyShape]], Morph]"),
    (r"\b(object|handle|function)\b", "Any"),
    (r"\bdict\b", "Dict[Any, Any]"),
    (r"\btuple\b", "Tuple[Any, ...]"),
    (r"\bnumpy\.ndarray\b(\[\w+\.\w+\])?", "numpy.ndarray[Any, Any]"),
]
# Items of lists that have a shorter way than their class.
SHORTER = {"Seed": "Union[Seed, Tuple[float, float, float], Tuple[float, float, float, str]]",
           "StartStep": "Union[StartStep, str]"}
FIELD_ONLY = re.compile(r"-> (.*)$", re.S)


class Signature(NamedTuple):
    parameters: List[str]
    result: str


def typed(text: str) -> str:
    for pattern, name in RENAMED:
        text = re.sub(pattern, name, text.strip())
    return text


def top_level(text: str, separators: str) -> Iterator[int]:
    """Where separators stand that no bracket and no quotation mark encloses."""
    depth, quote = 0, ""
    for place, letter in enumerate(text):
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "'\"":
            quote = letter
        elif letter in "([{<":
            depth += 1
        elif letter in ")]}>" and text[place - 1 : place + 1] != "->":
            if letter in separators and depth == 0:
                yield place
            depth -= 1
        elif depth == 0 and letter in separators:
            yield place


def split(text: str, separator: str) -> List[str]:
    ends = [*top_level(text, separator), len(text)]
    starts = [0, *(end + 1 for end in ends)]
    return [text[a:b].strip() for a, b in zip(starts, ends) if text[a:b].strip()]


def parameter(text: str) -> str:
    if text.startswith("*"):
        return f"{text}: Any"
    name, _, rest = text.partition(":")
    kind, *default = split(rest, "=")
    name = "self" if name == "self" else re.sub(r"^arg\d+$", lambda found: "_" + found[0], name)
    return name if name == "self" else f"{name}: {given(typed(kind))}" + (" = ..." if default else "")


def signatures(function: Any) -> List[Signature]:
    """Those that pybind11 wrote into the docstring, one per overload."""
    doc, found = inspect.getdoc(function) or "", []
    for start in re.finditer(r"(?:^|\n)(?:\d+\. )?" + re.escape(function.__name__) + r"\(", doc):
        rest = doc[start.end() :]
        end = next(top_level(rest, ")"), None)
        if end is None or not rest[end + 1 :].startswith(" -> "):
            continue
        parameters = [parameter(text) for text in split(rest[:end], ",")]
        if parameters and parameters[0].startswith("_arg0"):
            parameters[0] = "self"
        found.append(Signature(parameters, typed(rest[end + 5 :].split("\n")[0])))
    return found


def given(kind: str) -> str:
    """Of a parameter: whatever makes an array will do for one."""
    return kind.replace("numpy.ndarray[Any, Any]", "ArrayLike").replace("List[", "Sequence[")


def wrapped(line: str) -> Iterator[str]:
    """Lines of at most 120 columns, broken after commas between parameters."""
    indent = line[: len(line) - len(line.lstrip())]
    start = line.index("(") + 1
    breaks = [start + place + 1 for place in top_level(line[start:], ",")]
    text = "".join(" " if i in breaks else "\0" if letter == " " else letter for i, letter in enumerate(line))
    for part in textwrap.wrap(text, 120, subsequent_indent=indent + "    ", break_long_words=False,
                              break_on_hyphens=False):
        yield part.replace("\0", " ")


def defined(name: str, function: Any, indent: str, decorator: str = "") -> Iterator[str]:
    every = signatures(function)
    for signature in every:
        if len(every) > 1:
            yield f"{indent}@overload"
        if decorator:
            yield f"{indent}@{decorator}"
        ignored = "  # type: ignore[override]" if name == "__eq__" else ""
        yield from wrapped(f"{indent}def {name}({', '.join(signature.parameters)}) -> {signature.result}: ...{ignored}")


def field_type(value: property) -> str:
    found = FIELD_ONLY.search(inspect.getdoc(value.fget) or "")
    return typed(found[1].split("\n")[0]) if found else "Any"


def given_type(kind: type, name: str, module: Any) -> str:
    """What a constructor takes for a field: enumerators and kernels by their names, too."""
    text = field_type(vars(kind)[name])
    if hasattr(getattr(module, text, None), "__members__") or text == "Kernel":
        return f"Union[{text}, str]"
    items = re.fullmatch(r"Tuple\[(\w+), \.\.\.\]", text)
    return f"Iterable[{SHORTER.get(items[1], items[1])}]" if items else given(text)


def constructor(kind: type, module: Any) -> Iterator[str]:
    if hasattr(kind, "__signature__"):
        names = [f"{name}: {given_type(kind, name, module)} = ..." for name in kind.__signature__.parameters]
        yield from wrapped(f"    def __init__(self, *, {', '.join(names)}) -> None: ...")
    elif "__init__" in vars(kind):
        yield from defined("__init__", vars(kind)["__init__"], "    ")


def class_lines(name: str, kind: type, module: Any) -> Iterator[str]:
    yield f"class {name}:"
    if hasattr(kind, "__members__"):
        for member in kind.__members__:
            yield f"    {member}: ClassVar[{name}]"
        yield f"    __members__: ClassVar[Dict[str, {name}]]"
        yield "    def __init__(self, value: int) -> None: ..."
        yield "    def __int__(self) -> int: ..."
        yield "    @property\n    def name(self) -> str: ...\n    @property\n    def value(self) -> int: ..."
        return
    if hasattr(kind, "_fields"):
        yield "    _fields: ClassVar[Tuple[str, ...]]"
    yield from constructor(kind, module)
    for key, value in vars(kind).items():
        if isinstance(value, property) and value.fset and given_type(kind, key, module) == field_type(value):
            yield f"    {key}: {field_type(value)}"
        elif isinstance(value, property):
            yield f"    @property\n    def {key}(self) -> {field_type(value)}: ..."
            if value.fset is not None:
                yield f"    @{key}.setter\n    def {key}(self, value: {given_type(kind, key, module)}) -> None: ..."
        elif key == "__iter__":
            yield f"    def __iter__(self) -> Iterator[{signatures(kind.__getitem__)[0].result}]: ..."
        elif isinstance(value, staticmethod):
            yield from defined(key, value.__func__, "    ", "staticmethod")
        elif callable(value) and key not in ("__init__", "__repr__", "__new__", "__getstate__", "__setstate__"):
            yield from defined(key, value, "    ")


def exported(module: Any) -> List[str]:
    """What the package has from here: all that no verb written in Python takes the place of."""
    import isostack

    public = [name for name in vars(module) if not name.startswith("_")]
    return [name for name in public if vars(isostack).get(name) is vars(module)[name]]


def stubs(module: Any) -> str:
    names: List[Tuple[str, Any]] = [item for item in vars(module).items() if not item[0].startswith("_")]
    lines = [HEADER, "__all__ = [", *(f'    "{name}",' for name in exported(module)), "]"]
    for name, value in names:
        if isinstance(value, type):
            lines += ["", *class_lines(name, value, module), ""]
    for name, value in names:
        if not isinstance(value, type) and callable(value):
            lines += defined(name, value, "")
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)) + "\n"


if __name__ == "__main__":
    sys.path.pop(0)  # this folder has the package's sources, but not the compiled part
    import isostack._core

    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(stubs(isostack._core))
