#pragma once

// How small C++ values look in Python. Included by every file that binds: a type must be converted alike everywhere.

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "recon/geometry/color.h"
#include "segmentation/start_steps.h"
#include "segmentation/threshold.h"

// A class of its own, not one of its alternatives.
PYBIND11_MAKE_OPAQUE(isostack::StartStep)

namespace isostack::python {

/// A tuple whose items' type signatures tell.
template <class Item>
class TupleOf : public pybind11::tuple {
 public:
  TupleOf(const pybind11::object& items) : pybind11::tuple(items) {}
};

}  // namespace isostack::python

namespace pybind11::detail {

template <class Item>
struct handle_type_name<isostack::python::TupleOf<Item>> {
  static constexpr auto name = const_name("Tuple[") + make_caster<Item>::name + const_name(", ...]");
};

/// (red, green, blue), each 0 to 255.
template <>
struct type_caster<isostack::Color> {
  PYBIND11_TYPE_CASTER(isostack::Color, const_name("Tuple[int, int, int]"));

  bool load(handle source, bool) {
    if (!isinstance<sequence>(source) || isinstance<str>(source)) return false;
    const auto channels = reinterpret_borrow<sequence>(source);
    if (channels.size() != 3) return false;
    make_caster<std::uint8_t> red, green, blue;
    if (!red.load(channels[0], true) || !green.load(channels[1], true) || !blue.load(channels[2], true)) return false;
    value = {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green), static_cast<std::uint8_t>(blue)};
    return true;
  }
  static handle cast(const isostack::Color& color, return_value_policy, handle) {
    return make_tuple(color.red, color.green, color.blue).release();
  }
};

/// (low, high)
template <>
struct type_caster<isostack::GreyRange> {
  PYBIND11_TYPE_CASTER(isostack::GreyRange, const_name("Tuple[float, float]"));

  bool load(handle source, bool) {
    if (!isinstance<sequence>(source) || isinstance<str>(source)) return false;
    const auto limits = reinterpret_borrow<sequence>(source);
    if (limits.size() != 2) return false;
    make_caster<double> low, high;
    if (!low.load(limits[0], true) || !high.load(limits[1], true)) return false;
    value = {static_cast<double>(low), static_cast<double>(high)};
    return true;
  }
  static handle cast(const isostack::GreyRange& range, return_value_policy, handle) {
    return make_tuple(range.low, range.high).release();
  }
};

}  // namespace pybind11::detail
