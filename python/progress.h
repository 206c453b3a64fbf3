#pragma once

#include <pybind11/pybind11.h>

#include "recon/geometry/progress.h"

namespace isostack::python {

/// Progress of a call from Python, for work without the interpreter's lock. Reports take the lock: they call
/// `callback(step, fraction)`, unless it is None, and let Python handle signals, so that Ctrl-C in the main thread
/// stops the work with KeyboardInterrupt. What the callback raises stops it, too, and comes out as it is. A report
/// between two steps less than a twentieth of a second after the last one is passed over.
Progress progress_of(const pybind11::object& callback);

/// work(progress) without the interpreter's lock.
template <class Work>
auto without_lock(const pybind11::object& callback, Work work) {
  const Progress progress = progress_of(callback);
  const pybind11::gil_scoped_release release;
  return work(progress);
}

}  // namespace isostack::python
