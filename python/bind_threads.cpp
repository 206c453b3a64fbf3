#include <oneapi/tbb/global_control.h>

#include <memory>

#include "python/bindings.h"
#include "recon/solvers/thread_count.h"

namespace isostack::python {

namespace py = pybind11;

namespace {

/// As long as this lives, the work uses no more threads.
class ThreadLimit {
 public:
  explicit ThreadLimit(int count) {
    if (count < 1) throw py::value_error("at least one thread is needed");
    limit_ = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                   static_cast<std::size_t>(count));
  }

  void release() { limit_.reset(); }

 private:
  std::unique_ptr<tbb::global_control> limit_;
};

}  // namespace

void bind_threads(py::module_& core) {
  py::class_<ThreadLimit> limit(core, "ThreadLimit",
                                "with isostack.ThreadLimit(2): the work within uses no more threads. Results do not "
                                "depend on their number.");
  limit.def(py::init<int>(), py::arg("count"));
  limit.def("release", &ThreadLimit::release, "As many threads as there are again.");
  limit.def(
      "__enter__", [](ThreadLimit& self) -> ThreadLimit& { return self; }, py::return_value_policy::reference_internal);
  limit.def("__exit__", [](ThreadLimit& self, const py::args&) { self.release(); });
  core.def("available_threads", &available_threads, "Threads this process may use.");
}

}  // namespace isostack::python
