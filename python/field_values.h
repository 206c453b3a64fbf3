#pragma once

#include <Eigen/Core>
#include <optional>
#include <type_traits>
#include <vector>

#include "python/casters.h"
#include "recon/kernels/kernel.h"

namespace isostack::python {

namespace py = pybind11;

template <class T>
struct ListTraits : std::false_type {};
template <class T>
struct ListTraits<std::vector<T>> : std::bool_constant<!std::is_arithmetic_v<T>> {};
template <class T>
constexpr bool is_list = ListTraits<T>::value;

/// Members that keep their place as long as the object lives, and may be seen by reference: structs, short vectors.
template <class T>
struct PartTraits : std::is_class<T> {};
template <class T>
struct PartTraits<std::optional<T>> : std::false_type {};
template <class T>
struct PartTraits<std::vector<T>> : std::false_type {};
template <class T, int R, int C, int O, int MR, int MC>
struct PartTraits<Eigen::Matrix<T, R, C, O, MR, MC>> : std::bool_constant<R != Eigen::Dynamic && C != Eigen::Dynamic> {
};
template <class T>
constexpr bool is_part = PartTraits<T>::value;

/// The fields of a class made by StructClass: its attribute _fields.
py::tuple fields_of(const py::handle& type);

/// Sets attributes. Throws TypeError for a name that is no field that can be set, with the nearest one that is.
void set_fields(const py::object& object, const py::dict& fields);

/// "Name(field=value, ...)"
std::string repr_of(const py::object& object);

/// Structs as dicts, arrays and tuples as lists, enumerators as their names; what has no such form as its repr.
py::object as_plain(const py::handle& value);

/// What inspect.signature shows: keywords with their defaults.
void set_signature(const py::object& type, const py::object& defaults);

/// TypeError: "Options.field takes float, not 'x'".
[[noreturn]] void throw_wrong_type(const py::handle& value, const py::handle& type, const char* field);
/// ValueError: "Options.field: 'x' is none of round, flat, open".
[[noreturn]] void throw_unknown_name(const py::handle& value, const py::handle& enumeration, const py::handle& type,
                                     const char* field);

/// How an item of a list is given, for types that have a shorter way than their class.
template <class Item>
struct ItemReader {
  static Item read(const py::handle& item) { return py::cast<Item>(item); }
};

template <class Items>
Items items_of(const py::object& value) {
  Items items;
  for (const py::handle item : py::iter(value)) items.push_back(ItemReader<typename Items::value_type>::read(item));
  return items;
}

/// The value for a field of a class. Enumerators and kernels may be given by name.
template <class Member>
Member value_of(const py::object& value, const py::handle& type, const char* field) {
  if constexpr (std::is_enum_v<Member>)
    if (py::isinstance<py::str>(value)) {
      const py::dict members = py::type::of<Member>().attr("__members__");
      if (!members.contains(value)) throw_unknown_name(value, py::type::of<Member>(), type, field);
      return py::cast<Member>(members[value]);
    }
  if constexpr (std::is_same_v<Member, Kernel>)
    if (py::isinstance<py::str>(value)) return kernel_named(py::cast<std::string>(value));
  if constexpr (is_list<Member>)
    if (!py::isinstance<py::str>(value) && py::isinstance<py::sequence>(value)) try {
        return items_of<Member>(value);
      } catch (const py::cast_error&) {
        throw_wrong_type(value, type, field);
      }
  py::detail::make_caster<Member> caster;
  if (!caster.load(value, true)) throw_wrong_type(value, type, field);
  return py::detail::cast_op<Member>(std::move(caster));
}

}  // namespace isostack::python
