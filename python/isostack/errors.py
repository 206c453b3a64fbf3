"""What the verbs raise. Every message is one sentence: where, what was wrong, what to do."""

__all__ = [
    "Cancelled", "Error", "GeometryError", "InputError", "InputWarning", "SolveError",
]


class Error(Exception):
    """Base of what isostack raises.

    where: the file, slice or option; problem: what was wrong; remedy: what to do about it.
    """

    def __init__(self, where: str, problem: str, remedy: str) -> None:
        super().__init__(where, problem, remedy)
        self.where = where
        self.problem = problem
        self.remedy = remedy

    def __str__(self) -> str:
        return f"{self.where}: {self.problem}; {self.remedy}."


class InputError(Error, ValueError):
    """A file or value handed over is missing, broken or contradicts another."""


class GeometryError(Error, ValueError):
    """Slices, contours or meshes whose geometry cannot be used as asked."""


class SolveError(Error, RuntimeError):
    """A solve that cannot reach its tolerance or does not fit into memory."""


class Cancelled(Exception):
    """The caller asked to stop; nothing was produced."""


class InputWarning(UserWarning):
    """What a user must know before trusting what was read."""
