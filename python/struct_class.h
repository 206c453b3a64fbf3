#pragma once

#include <string>

#include "python/casters.h"
#include "python/field_values.h"

namespace isostack::python {

/// A struct of plain values as a Python class: attributes of the same names, a constructor from keywords that refuses
/// unknown ones with a TypeError, a repr, `replace(**fields)` and `as_dict()`. Ends with done().
template <class T>
class StructClass {
 public:
  StructClass(py::module_& scope, const char* name, const char* about) : class_(scope, name), doc_(about) {}

  /// Set and shown. Struct members are references into the object, lists come out as tuples.
  template <class Member>
  StructClass& field(const char* name, Member T::*member, const char* about) {
    return add(name, reader(member), writer(name, member), about);
  }
  /// Shown only.
  template <class Member>
  StructClass& result(const char* name, Member T::*member, const char* about) {
    return add(name, reader(member), py::cpp_function(), about);
  }

  /// For options and plain values.
  py::class_<T>& done() {
    class_.def(py::init([](const py::kwargs& fields) {
      T value;
      set_fields(py::cast(&value, py::return_value_policy::reference), fields);
      return value;
    }));
    class_.def(
        "replace",
        [](const T& self, const py::kwargs& fields) {
          T value(self);
          set_fields(py::cast(&value, py::return_value_policy::reference), fields);
          return value;
        },
        "A copy with these fields changed.");
    add_common();
    set_signature(class_, py::cast(T{}));
    return class_;
  }
  /// For results, which only the library makes.
  py::class_<T>& done_as_result() {
    add_common();
    return class_;
  }

 private:
  template <class Member>
  static py::cpp_function reader(Member T::*member) {
    if constexpr (is_list<Member>)  // a list would promise that appending to it changes the object
      return py::cpp_function(
          [member](const T& object) { return TupleOf<typename Member::value_type>(py::cast(object.*member)); });
    else if constexpr (is_part<Member>)
      return py::cpp_function([member](T& object) -> Member& { return object.*member; },
                              py::return_value_policy::reference_internal);
    else
      return py::cpp_function([member](const T& object) -> Member { return object.*member; });
  }
  template <class Member>
  static py::cpp_function writer(const char* name, Member T::*member) {
    return py::cpp_function([name, member](T& object, const py::object& value) {
      object.*member = value_of<Member>(value, py::type::of<T>(), name);
    });
  }
  StructClass& add(const char* name, const py::cpp_function& get, const py::cpp_function& set, const char* about) {
    class_.def_property(name, get, set, about);
    names_.append(name);
    doc_ += std::string("\n    ") + name + ": " + about;
    return *this;
  }
  void add_common() {
    class_.attr("_fields") = py::tuple(names_);
    class_.attr("__doc__") = doc_;
    class_.def("__repr__", [](const py::object& self) { return repr_of(self); });
    class_.def(
        "as_dict", [](const py::object& self) { return as_plain(self); },
        "The values by name, as plain Python values: for JSON.");
    class_.def("__copy__", [](const T& self) { return T(self); });
    class_.def(
        "__deepcopy__", [](const T& self, const py::dict&) { return T(self); }, py::arg("memo"));
  }

  py::class_<T> class_;
  std::string doc_;
  py::list names_;
};

}  // namespace isostack::python
