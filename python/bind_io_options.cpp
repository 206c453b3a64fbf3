#include "io/read_slices.h"
#include "io/write_options.h"
#include "python/bindings.h"
#include "python/struct_class.h"

namespace isostack::python {

void bind_io_options(py::module_& core) {
  py::enum_<MeshAxes>(core, "MeshAxes", "World axes of a mesh file.")
      .value("lps", MeshAxes::lps, "as DICOM")
      .value("ras", MeshAxes::ras, "as some programs expect");
  StructClass<ReadOptions>(core, "ReadOptions", "Which part of an input is meant, and how it is taken.\n")
      .field("series", &ReadOptions::series,
             "DICOM: a series' number in inspect(), its UID or the end of it; \"all\": every image series, as one "
             "scene; \"\": the only one")
      .field("phase", &ReadOptions::phase,
             "DICOM: which of several pictures of the same places, from 1; None: there must be one")
      .field("spacing_mm", &ReadOptions::spacing_mm, "column, row and slice distance of PNG and TIFF stacks, mm")
      .field("unite_contours", &ReadOptions::unite_contours,
             "RTSTRUCT: inside is what lies within any contour of a slice; otherwise within an odd number of them")
      .field("images", &ReadOptions::images, "RTSTRUCT: the images it was drawn on; None: looked for in its folder")
      .done();
  StructClass<WriteOptions>(core, "WriteOptions", "What some formats need to know beyond the data itself.\n")
      .field("like", &WriteOptions::like,
             "the image series or volume that the object refers to: RTSTRUCT and SEG name its slices")
      .field("like_series", &WriteOptions::like_series, "which series of `like`, as ReadOptions.series")
      .field("identify", &WriteOptions::identify,
             "DICOM: copy the patient's name, ID and the like from `like`; otherwise they stay empty")
      .field("axes", &WriteOptions::axes, "of STL, PLY, OBJ and VTP: \"lps\" or \"ras\"; glTF prescribes its own")
      .field("compressed", &WriteOptions::compressed, "voxels of NRRD and MetaImage; NIfTI's are by its name")
      .done();
}

}  // namespace isostack::python
