#include "python/arrays.h"

#include "recon/geometry/errors.h"

namespace isostack::python {

namespace {

std::string text_of(const py::handle& object) { return py::str(object); }

bool is_real(char kind) { return kind == 'f' || kind == 'i' || kind == 'u' || kind == 'b'; }
bool is_whole(char kind) { return kind == 'i' || kind == 'u' || kind == 'b'; }

void require_range(const py::array& array, const py::dtype& type, const std::string& what) {
  if (array.size() == 0 || array.dtype().kind() == 'b') return;
  const py::object limits = py::module_::import("numpy").attr("iinfo")(type);
  if (py::bool_(array.attr("min")() < limits.attr("min")) || py::bool_(array.attr("max")() > limits.attr("max")))
    throw InputError(what, "a value in it does not fit into " + text_of(type),
                     "keep values from " + text_of(limits.attr("min")) + " to " + text_of(limits.attr("max")));
}

}  // namespace

py::array checked_array(const py::object& array, const py::dtype& type, int dimensions, const std::string& what) {
  const py::module_ numpy = py::module_::import("numpy");
  const py::array given = numpy.attr("asarray")(array);
  const bool whole = is_whole(type.kind());
  const bool is_empty_list = given.size() == 0 && !py::isinstance<py::array>(array);
  if (!is_empty_list && !(whole ? is_whole(given.dtype().kind()) : is_real(given.dtype().kind())))
    throw py::type_error(what + " takes an array of " + (whole ? "whole" : "real") + " numbers, not of " +
                         text_of(given.dtype()));
  if (given.ndim() != dimensions && !is_empty_list)
    throw InputError(what, "its shape is " + text_of(given.attr("shape")),
                     "give an array of " + std::to_string(dimensions) + " dimensions");
  if (whole) require_range(given, type, what);
  return numpy.attr("ascontiguousarray")(given, type);
}

py::array checked_rows(const py::object& array, const py::dtype& type, int columns, const std::string& what) {
  py::array rows = checked_array(array, type, 2, what);
  if (rows.size() == 0) return py::array(type, {py::ssize_t{0}, static_cast<py::ssize_t>(columns)});
  if (rows.shape(1) != columns)
    throw InputError(what, "its shape is " + text_of(rows.attr("shape")),
                     "give an array of shape (N, " + std::to_string(columns) + ")");
  return rows;
}

void assign_in_place(const py::array& view, const py::object& values, const std::string& what) {
  const py::array given = checked_array(values, view.dtype(), static_cast<int>(view.ndim()), what);
  if (!given.attr("shape").equal(view.attr("shape")))
    throw InputError(
        what, "it keeps its shape " + text_of(view.attr("shape")) + ", the values have " + text_of(given.attr("shape")),
        "make a new object with the new array");
  view[py::ellipsis()] = given;
}

}  // namespace isostack::python
