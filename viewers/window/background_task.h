#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "recon/geometry/progress.h"

namespace isostack {

enum class TaskState { idle, running, done, failed, cancelled };

struct TaskStatus {
  TaskState state = TaskState::idle;
  std::string stage = {};    ///< the work's own word for what it does
  double fraction = 0;       ///< of that stage
  std::string message = {};  ///< one sentence when it failed
  double seconds = 0;        ///< since it started, or that it took
};

/// Work in a thread of its own, one at a time, that leaves the caller's thread free. All functions are to be called
/// from one thread. The work and the TBB threads that help it yield to the caller: they have a lower priority.
class BackgroundWorker {
 public:
  BackgroundWorker();
  /// Cancels and waits for the work to stop.
  ~BackgroundWorker();
  BackgroundWorker(const BackgroundWorker&) = delete;
  BackgroundWorker& operator=(const BackgroundWorker&) = delete;

  /// Cancels what still runs, waits for it, and starts. Exceptions of the work become its status.
  void start(std::function<void(const Progress&)> work);
  /// Asks the work to stop; it does so when it next reports.
  void cancel();
  /// The same, and waits until it has.
  void stop();
  TaskStatus status() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

/// Such work with a result.
template <class Result>
class BackgroundTask {
 public:
  void start(std::function<Result(const Progress&)> work) {
    auto result = std::make_shared<std::optional<Result>>();
    result_ = result;
    worker_.start([work = std::move(work), result](const Progress& progress) { *result = work(progress); });
  }
  void cancel() { worker_.cancel(); }
  void stop() { worker_.stop(); }
  TaskStatus status() const { return worker_.status(); }
  bool is_running() const { return status().state == TaskState::running; }

  /// The result, once, after the work is done.
  std::optional<Result> take() {
    if (!result_ || status().state != TaskState::done) return std::nullopt;
    return std::move(*std::exchange(result_, nullptr));
  }

 private:
  std::shared_ptr<std::optional<Result>> result_;
  BackgroundWorker worker_;  ///< last, so that its thread ends before the result goes
};

}  // namespace isostack
