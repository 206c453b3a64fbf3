#include "viewers/window/background_task.h"

#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_scheduler_observer.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <thread>

#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"

namespace isostack {

namespace {

constexpr int niceness = 10;

/// Of the calling thread only: that is what 0 means on Linux. Where it is refused the work just competes.
void yield_to_others() { setpriority(PRIO_PROCESS, 0, std::max(niceness, getpriority(PRIO_PROCESS, 0))); }

class YieldingThreads : public tbb::task_scheduler_observer {
 public:
  explicit YieldingThreads(tbb::task_arena& arena) : task_scheduler_observer(arena) { observe(true); }
  ~YieldingThreads() override { observe(false); }
  void on_scheduler_entry(bool /*is_worker*/) override { yield_to_others(); }
};

}  // namespace

struct BackgroundWorker::Shared {
  std::atomic<bool> is_cancelled = false;
  mutable std::mutex guard;  ///< of what follows
  TaskStatus status;
  Stopwatch watch;
  std::thread thread;

  void set(TaskState state, const std::string& message) {
    const std::lock_guard lock(guard);
    status.state = state;
    status.message = message;
    status.seconds = watch.seconds();
  }

  Progress progress() {
    return {.on_report =
                [this](std::string_view stage, double fraction) {
                  const std::lock_guard lock(guard);
                  status.stage = stage;
                  status.fraction = fraction;
                },
            .is_cancelled = [this] { return is_cancelled.load(); }};
  }

  void run(const std::function<void(const Progress&)>& work) {
    try {
      tbb::task_arena arena;
      const YieldingThreads yielding(arena);
      yield_to_others();
      arena.execute([&] { work(progress()); });
      set(is_cancelled ? TaskState::cancelled : TaskState::done, "");
    } catch (const Cancelled&) {
      set(TaskState::cancelled, "");
    } catch (const std::bad_alloc&) {
      set(TaskState::failed, "memory: there is not enough of it; use fewer constraints.");
    } catch (const std::exception& error) {
      set(TaskState::failed, error.what());
    }
  }
};

BackgroundWorker::BackgroundWorker() : shared_(std::make_shared<Shared>()) {}

BackgroundWorker::~BackgroundWorker() { stop(); }

void BackgroundWorker::stop() {
  shared_->is_cancelled = true;
  if (shared_->thread.joinable()) shared_->thread.join();
}

void BackgroundWorker::start(std::function<void(const Progress&)> work) {
  stop();
  shared_ = std::make_shared<Shared>();
  shared_->status.state = TaskState::running;
  Shared& shared = *shared_;
  shared.thread = std::thread([&shared, work = std::move(work)] { shared.run(work); });
}

void BackgroundWorker::cancel() { shared_->is_cancelled = true; }

TaskStatus BackgroundWorker::status() const {
  const std::lock_guard lock(shared_->guard);
  TaskStatus status = shared_->status;
  if (status.state == TaskState::running) status.seconds = shared_->watch.seconds();
  return status;
}

}  // namespace isostack
