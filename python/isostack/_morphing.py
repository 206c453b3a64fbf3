"""Shapes between given shapes."""

from typing import Any, Iterable, List, NamedTuple, Optional, Sequence, Tuple, Union

from isostack import _core
from isostack._core import (
    BlendMorphOptions, ContourSlice, KeyShape, LandmarkPair, LevelSetCourse, LevelSetMorphOptions, Morph,
    SignedDistanceMorphOptions, SubdivisionMorphOptions, TriangleMesh, UnsharedPart, VariationalMorphOptions)
from isostack._options import Progress, merged

__all__ = [
    "LevelSetMorph", "blend_morph", "level_set_morph", "morph", "run_level_set_morph", "signed_distance_morph",
    "subdivision_morph", "variational_morph",
]

Shape = Union[KeyShape, ContourSlice, TriangleMesh]
Landmarks = Iterable[Union[LandmarkPair, Tuple[Any, Any]]]


class LevelSetMorph(NamedTuple):
    """A level-set morph, how each evolution went, and parts of key shapes that the one before does not overlap."""

    morph: Morph
    courses: List[LevelSetCourse]
    unshared: List[UnsharedPart]


def _keys(shapes: Iterable[Shape]) -> List[KeyShape]:
    return [shape if isinstance(shape, KeyShape) else KeyShape(shape, name=shape.name or f"shape {number}")
            for number, shape in enumerate(shapes)]


def _pairs(landmarks: Landmarks) -> List[LandmarkPair]:
    return [pair if isinstance(pair, LandmarkPair) else LandmarkPair(*pair) for pair in landmarks]


def variational_morph(shapes: Iterable[Shape], options: Optional[VariationalMorphOptions] = None, *,
                      progress: Progress = None, **fields: Any) -> Morph:
    """One function of space and the extra dimensions, solved once through all key shapes (Turk & O'Brien 1999)."""
    return _core.variational_morph(_keys(shapes), merged(VariationalMorphOptions, options, fields), progress)


def signed_distance_morph(shapes: Iterable[Shape], options: Optional[SignedDistanceMorphOptions] = None, *,
                          progress: Progress = None, **fields: Any) -> Morph:
    """The baseline: where the weighted mean of the key shapes' signed distances is positive."""
    return _core.signed_distance_morph(_keys(shapes), merged(SignedDistanceMorphOptions, options, fields), progress)


def blend_morph(shapes: Iterable[Shape], options: Optional[BlendMorphOptions] = None, *, progress: Progress = None,
                **fields: Any) -> Morph:
    """Bounded space-time blending (Pasko, Pasko & Kunii 2004)."""
    return _core.blend_morph(_keys(shapes), merged(BlendMorphOptions, options, fields), progress)


def subdivision_morph(shapes: Iterable[Shape], options: Optional[SubdivisionMorphOptions] = None, *,
                      progress: Progress = None, **fields: Any) -> Morph:
    """Blending by subdivision surfaces (Ohbuchi, Kokojima & Takahashi 2001)."""
    return _core.subdivision_morph(_keys(shapes), merged(SubdivisionMorphOptions, options, fields), progress)


def run_level_set_morph(shapes: Iterable[Shape], options: Optional[LevelSetMorphOptions] = None, *,
                        progress: Progress = None, **fields: Any) -> LevelSetMorph:
    """level_set_morph with how each evolution went."""
    chosen = merged(LevelSetMorphOptions, options, fields)
    return LevelSetMorph(*_core.level_set_morph(_keys(shapes), chosen, progress))


def level_set_morph(shapes: Iterable[Shape], options: Optional[LevelSetMorphOptions] = None, *,
                    progress: Progress = None, **fields: Any) -> Morph:
    """Each shape moves along its normals until it is the next (Breen & Whitaker 2001)."""
    return run_level_set_morph(shapes, options, progress=progress, **fields).morph


_METHODS = {
    "variational": variational_morph,
    "level-set": level_set_morph,
    "blend": blend_morph,
    "subdivision": subdivision_morph,
    "signed-distance": signed_distance_morph,
}


def morph(shapes: Iterable[Shape], method: str = "variational", options: Any = None, *,
          landmarks: Optional[Landmarks] = None, progress: Progress = None, **fields: Any) -> Morph:
    """Shapes between two or more shapes: figures of one plane (ContourSlice) or closed bodies (TriangleMesh, LPS mm).

    method: "variational", "level-set", "blend", "subdivision" or "signed-distance"; `fields` are those of its options.
    landmarks: pairs of points (world LPS mm) of the first and the last shape that belong together. Raises InputError
    for shapes that do not fit together.
    """
    if method not in _METHODS:
        raise ValueError(f"method: {method!r} is none of {', '.join(_METHODS)}")
    make = _METHODS[method]
    keys = _keys(shapes)
    if landmarks is None:
        return make(keys, options, progress=progress, **fields)  # type: ignore[operator,no-any-return]
    if method == "subdivision":
        raise TypeError("subdivision takes features instead of landmarks")
    if method == "level-set":
        fields = {"transform": "warp", **fields, "landmarks": _pairs(landmarks)}
        return level_set_morph(keys, options, progress=progress, **fields)

    def made(displaced: Sequence[KeyShape]) -> Morph:
        return make(displaced, options, progress=progress, **fields)  # type: ignore[operator,no-any-return]

    return _core.warped_morph(keys, _pairs(landmarks), made)
