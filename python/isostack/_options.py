"""What several verbs share: options, progress, warnings, paths."""

import os
import warnings
from typing import Any, Callable, Dict, Iterable, Optional, Type, TypeVar, Union

from isostack.errors import InputWarning

Options = TypeVar("Options")
Path = Union[str, "os.PathLike[str]"]
Progress = Optional[Callable[[str, float], object]]


def merged(kind: Type[Options], options: Optional[Options], fields: Dict[str, Any]) -> Options:
    """The options with these fields changed. Raises TypeError for a field that there is not."""
    if options is None:
        return kind(**fields)
    if not isinstance(options, kind):
        raise TypeError(f"options takes {kind.__name__}, not {options!r}")
    return options.replace(**fields) if fields else options  # type: ignore[attr-defined,no-any-return]


def warn(remarks: Iterable[str]) -> None:
    """One InputWarning each, at the line that called the verb."""
    for remark in remarks:
        warnings.warn(remark, InputWarning, stacklevel=3)
