#include "python/progress.h"

#include <chrono>
#include <memory>
#include <string>
#include <thread>

namespace isostack::python {

namespace py = pybind11;

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto between_reports = std::chrono::milliseconds(50);

class Reports {
 public:
  explicit Reports(py::object callback) : callback_(std::move(callback)) {}

  void report(std::string_view step, double fraction) {
    if (std::this_thread::get_id() != thread_) return;  // another thread may not handle signals
    const bool is_new_step = step != step_;
    const Clock::time_point now = Clock::now();
    if (!is_new_step && fraction < 1 && now - last_ < between_reports) return;
    last_ = now;
    step_ = step;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!callback_.is_none()) callback_(py::str(step.data(), step.size()), fraction);
  }

 private:
  py::object callback_;
  std::thread::id thread_ = std::this_thread::get_id();
  std::string step_;
  Clock::time_point last_ = {};
};

}  // namespace

Progress progress_of(const py::object& callback) {
  if (!callback.is_none() && !PyCallable_Check(callback.ptr()))
    throw py::type_error("progress takes a callable of a step and a fraction, not " + std::string(py::repr(callback)));
  // The last copy may go without the lock.
  const auto release = [](Reports* reports) {
    const py::gil_scoped_acquire lock;
    delete reports;
  };
  const std::shared_ptr<Reports> reports(new Reports(callback), release);
  return {.on_report = [reports](std::string_view step, double fraction) { reports->report(step, fraction); },
          .is_cancelled = {}};
}

}  // namespace isostack::python
