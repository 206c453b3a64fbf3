#include <exception>
#include <utility>

#include "python/bindings.h"
#include "recon/geometry/errors.h"

namespace isostack::python {

namespace py = pybind11;

namespace {

void raise(const char* name, const Error& error) {
  const py::object type = py::module_::import("isostack.errors").attr(name);
  const py::object value = type(error.where(), error.problem(), error.remedy());
  PyErr_SetObject(type.ptr(), value.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const InputError& error) {
    raise("InputError", error);
  } catch (const GeometryError& error) {
    raise("GeometryError", error);
  } catch (const SolveError& error) {
    raise("SolveError", error);
  } catch (const Error& error) {
    raise("Error", error);
  } catch (const Cancelled& cancelled) {
    PyErr_SetString(py::module_::import("isostack.errors").attr("Cancelled").ptr(), cancelled.what());
  }
}

}  // namespace

void bind_errors(py::module_& /*core*/) { py::register_local_exception_translator(translate); }

}  // namespace isostack::python
