#pragma once

#include <pybind11/pybind11.h>

namespace isostack::python {

// One function per concept, each in a file of its own. What a function's signature names must have been bound before:
// this is the order they are called in.
void bind_errors(pybind11::module_& core);
void bind_poses(pybind11::module_& core);
void bind_slices(pybind11::module_& core);
void bind_contours(pybind11::module_& core);
void bind_meshes(pybind11::module_& core);
void bind_volumes(pybind11::module_& core);
void bind_labels(pybind11::module_& core);
void bind_io_options(pybind11::module_& core);
void bind_readers(pybind11::module_& core);
void bind_writers(pybind11::module_& core);
void bind_inspect(pybind11::module_& core);
void bind_segmentation_options(pybind11::module_& core);
void bind_segmentation(pybind11::module_& core);
void bind_agreement(pybind11::module_& core);
void bind_crossings(pybind11::module_& core);
void bind_reconstruct_options(pybind11::module_& core);
void bind_reconstruct(pybind11::module_& core);
void bind_metrics(pybind11::module_& core);
void bind_studies(pybind11::module_& core);
void bind_distance(pybind11::module_& core);
void bind_morph(pybind11::module_& core);
void bind_morph_methods(pybind11::module_& core);
void bind_subdivision_morph(pybind11::module_& core);
void bind_level_set_morph(pybind11::module_& core);
void bind_scene(pybind11::module_& core);
void bind_threads(pybind11::module_& core);

}  // namespace isostack::python
