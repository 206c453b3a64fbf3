#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "python/casters.h"

namespace isostack::python {

namespace py = pybind11;

// Views: NumPy arrays over memory of a C++ object, without a copy. They keep their owner alive; writing through them
// changes the object. The memory never moves, for no attribute changes an array's size: a new object has a new size.

/// (N, columns) over a vector of points or of corners.
template <class Scalar, int Columns>
py::array rows_view(std::vector<Eigen::Matrix<Scalar, Columns, 1>>& rows, const py::handle& owner) {
  using Row = Eigen::Matrix<Scalar, Columns, 1>;
  static_assert(sizeof(Row) == Columns * sizeof(Scalar) && std::is_standard_layout_v<Scalar>,
                "rows lie one after the other, without gaps");
  return py::array_t<Scalar>({static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(Columns)},
                             rows.empty() ? nullptr : rows.front().data(), owner);
}

/// (rows, columns) over an image's pixels.
template <class Scalar>
py::array image_view(Eigen::Array<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>& image,
                     const py::handle& owner) {
  return py::array_t<Scalar>({image.rows(), image.cols()}, image.size() == 0 ? nullptr : image.data(), owner);
}

/// The array in C order with elements of this kind. Throws TypeError naming `what` when its elements are of another
/// kind: real numbers for floats, whole numbers within the type's range for integers; InputError when its number of
/// dimensions differs.
py::array checked_array(const py::object& array, const py::dtype& type, int dimensions, const std::string& what);

/// The same with `columns` columns.
py::array checked_rows(const py::object& array, const py::dtype& type, int columns, const std::string& what);

template <class Scalar, int Columns>
std::vector<Eigen::Matrix<Scalar, Columns, 1>> rows_from(const py::object& array, const std::string& what) {
  const py::array rows = checked_rows(array, py::dtype::of<Scalar>(), Columns, what);
  std::vector<Eigen::Matrix<Scalar, Columns, 1>> result(static_cast<std::size_t>(rows.shape(0)));
  if (!result.empty()) std::copy_n(static_cast<const Scalar*>(rows.data()), rows.size(), result.front().data());
  return result;
}

/// Puts values into a view. Throws InputError when its shape differs, for an array does not change its size.
void assign_in_place(const py::array& view, const py::object& values, const std::string& what);

}  // namespace isostack::python
