"""A scene inline in a notebook: an HTML page of its own, in a frame, that asks the network for nothing."""

import html
from typing import Any, Union

from isostack import _core
from isostack._core import ContourStack, Reconstruction, Scene, SliceStack, TriangleMesh

#: Larger surfaces are simplified for the picture, to keep the notebook small.
MOST_TRIANGLES = 100_000


def scene_of(value: Union[Scene, TriangleMesh, Reconstruction, ContourStack, SliceStack]) -> Scene:
    """What there is to see of a value."""
    if isinstance(value, Scene):
        return value
    if isinstance(value, Reconstruction):
        value = value.surface
    if isinstance(value, TriangleMesh):
        return Scene(surfaces=[value], title=value.name)
    if isinstance(value, ContourStack):
        return Scene(contours=[value], title=value.name)
    return Scene(slices=list(value.slices), title=value.name)


def inline_html(value: Any, height_pixels: int = 480) -> str:
    """The value as a frame that turns, moves and zooms."""
    page = _core.page_html(scene_of(value), most_triangles=MOST_TRIANGLES)
    return (f'<iframe srcdoc="{html.escape(page, quote=True)}" sandbox="allow-scripts" '
            f'style="width:100%;height:{height_pixels}px;border:0"></iframe>')


def _show(value: Any) -> str:
    try:
        return inline_html(value)
    except ValueError:  # nothing that can be shown
        return html.escape(repr(value))


def install() -> None:
    """Gives what can be seen its _repr_html_."""
    for kind in (Scene, TriangleMesh, Reconstruction, ContourStack):
        setattr(kind, "_repr_html_", _show)
