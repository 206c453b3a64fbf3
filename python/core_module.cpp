#include "python/bindings.h"

PYBIND11_MODULE(_core, core) {
  using namespace isostack::python;
  core.doc() = "Types and verbs of isostack's C++ libraries; import isostack, which has all of them.";
  core.attr("__version__") = ISOSTACK_VERSION;
  for (const auto bind : {bind_errors,
                          bind_poses,
                          bind_slices,
                          bind_contours,
                          bind_meshes,
                          bind_volumes,
                          bind_labels,
                          bind_io_options,
                          bind_readers,
                          bind_writers,
                          bind_inspect,
                          bind_segmentation_options,
                          bind_segmentation,
                          bind_agreement,
                          bind_crossings,
                          bind_reconstruct_options,
                          bind_reconstruct,
                          bind_metrics,
                          bind_studies,
                          bind_distance,
                          bind_morph,
                          bind_morph_methods,
                          bind_subdivision_morph,
                          bind_level_set_morph,
                          bind_scene,
                          bind_threads})
    bind(core);
}
