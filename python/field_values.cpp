#include "python/field_values.h"

#include <algorithm>

namespace isostack::python {

namespace {

std::string text_of(const py::handle& object) { return py::str(object); }

/// "float" of a field whose getter says "(arg0: Options) -> float".
std::string type_of_field(const py::handle& type, const char* field) {
  const std::string signature = text_of(type.attr(field).attr("fget").attr("__doc__"));
  const std::size_t arrow = signature.rfind("-> ");
  return arrow == std::string::npos ? "another type"
                                    : signature.substr(arrow + 3, signature.find('\n', arrow) - arrow - 3);
}

bool can_be_set(const py::handle& type, const py::handle& name) {
  return fields_of(type).contains(name) && !py::getattr(type, name).attr("fset").is_none();
}

[[noreturn]] void throw_no_field(const py::handle& type, const py::handle& name) {
  std::string message = text_of(type.attr("__name__")) + " has no field '" + text_of(name) + "'";
  if (fields_of(type).contains(name)) message = text_of(type.attr("__name__")) + "." + text_of(name) + " is a result";
  const py::list near = py::module_::import("difflib").attr("get_close_matches")(name, fields_of(type), 1);
  if (!near.empty() && !py::object(near[0]).equal(name)) message += "; did you mean '" + text_of(near[0]) + "'?";
  throw py::type_error(message);
}

}  // namespace

py::tuple fields_of(const py::handle& type) { return type.attr("_fields"); }

void set_fields(const py::object& object, const py::dict& fields) {
  const py::type type = py::type::of(object);
  for (const auto& [name, value] : fields) {
    if (!can_be_set(type, name)) throw_no_field(type, name);
    py::setattr(object, name, value);
  }
}

std::string repr_of(const py::object& object) {
  const py::type type = py::type::of(object);
  std::string text = text_of(type.attr("__name__")) + "(", comma;
  for (const py::handle name : fields_of(type)) {
    text += comma + text_of(name) + "=" + std::string(py::repr(py::getattr(object, name)));
    comma = ", ";
  }
  return text + ")";
}

py::object as_plain(const py::handle& value) {
  const py::type type = py::type::of(value);
  if (value.is_none() || py::isinstance<py::bool_>(value) || py::isinstance<py::int_>(value) ||
      py::isinstance<py::float_>(value) || py::isinstance<py::str>(value))
    return py::reinterpret_borrow<py::object>(value);
  if (py::hasattr(type, "__members__")) return value.attr("name");
  if (py::hasattr(value, "tolist")) return value.attr("tolist")();
  if (py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value)) {
    py::list list;
    for (const py::handle item : value) list.append(as_plain(item));
    return list;
  }
  if (!py::hasattr(type, "_fields")) return py::repr(value);
  py::dict dict;
  for (const py::handle name : fields_of(type)) dict[name] = as_plain(py::getattr(value, name));
  return dict;
}

void set_signature(const py::object& type, const py::object& defaults) {
  const py::module_ inspect = py::module_::import("inspect");
  const py::object parameter = inspect.attr("Parameter");
  py::list parameters;
  for (const py::handle name : fields_of(type))
    if (can_be_set(type, name))
      parameters.append(
          parameter(name, parameter.attr("KEYWORD_ONLY"), py::arg("default") = py::getattr(defaults, name)));
  type.attr("__signature__") = inspect.attr("Signature")(parameters);
}

void throw_wrong_type(const py::handle& value, const py::handle& type, const char* field) {
  throw py::type_error(text_of(type.attr("__name__")) + "." + field + " takes " + type_of_field(type, field) +
                       ", not " + std::string(py::repr(value)));
}

void throw_unknown_name(const py::handle& value, const py::handle& enumeration, const py::handle& type,
                        const char* field) {
  const py::str names = py::str(", ").attr("join")(enumeration.attr("__members__"));
  throw py::value_error(text_of(type.attr("__name__")) + "." + field + ": " + std::string(py::repr(value)) +
                        " is none of " + std::string(names));
}

}  // namespace isostack::python
