"""isostack: from stacks of medical image slices to one smooth closed surface per organ.

World is DICOM patient space (LPS), mm. f > 0 and distances > 0 are inside. Arrays that attributes give are views: they
share memory with their object and keep it alive.

    import isostack

    images = isostack.read_slices("series")
    organ = isostack.segment(images, level=226, largest=True)
    result = isostack.reconstruct(organ)
    isostack.write(result, "organ.stl")

Research software. Not a medical device, not for clinical use.
"""

from isostack import notebook as _notebook
from isostack._core import *
from isostack._core import __version__
from isostack._morphing import *
from isostack._reading import *
from isostack._verbs import *
from isostack._writing import *
from isostack.errors import *

_notebook.install()
