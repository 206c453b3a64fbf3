#pragma once

#include <string>
#include <vector>

#include "python/casters.h"
#include "recon/geometry/errors.h"

namespace isostack::python {

namespace py = pybind11;

/// The members of an object's list as references that keep the object alive. A tuple, for the list keeps its length.
template <class T>
TupleOf<T> references(std::vector<T>& items, const py::handle& owner) {
  py::tuple result(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    result[i] = py::cast(items[i], py::return_value_policy::reference_internal, owner);
  return TupleOf<T>(result);
}

/// Copies.
template <class T>
TupleOf<T> copies(const std::vector<T>& items) {
  return TupleOf<T>(py::cast(items));
}

/// The number of an item, counted from the end when it is negative. Throws IndexError.
inline std::size_t item_number(py::ssize_t index, std::size_t count) {
  const py::ssize_t from_start = index < 0 ? index + static_cast<py::ssize_t>(count) : index;
  if (from_start < 0 || from_start >= static_cast<py::ssize_t>(count))
    throw py::index_error("there is no item " + std::to_string(index) + " among " + std::to_string(count));
  return static_cast<std::size_t>(from_start);
}

/// Copies of the items that a slice such as [::4] or a list of numbers names.
template <class T>
std::vector<T> chosen(const std::vector<T>& items, const py::slice& range) {
  std::size_t start = 0, stop = 0, step = 0, length = 0;
  if (!range.compute(items.size(), &start, &stop, &step, &length)) throw py::error_already_set();
  std::vector<T> result;
  for (std::size_t i = 0; i < length; ++i, start += step) result.push_back(items[start]);
  return result;
}
template <class T>
std::vector<T> chosen(const std::vector<T>& items, const std::vector<py::ssize_t>& numbers) {
  std::vector<T> result;
  for (const py::ssize_t number : numbers) result.push_back(items[item_number(number, items.size())]);
  return result;
}

}  // namespace isostack::python
