#include "io/dicom/child_processes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <new>

namespace isostack {

namespace {

enum TaskState : int { kUntouched, kBegun, kDone, kFailed };

/// Memory that children share with their parent: a counter, the tasks' states and their results.
class SharedMemory {
 public:
  explicit SharedMemory(const std::vector<std::size_t>& result_bytes) : count_(result_bytes.size()) {
    std::size_t end = sizeof(std::atomic<std::size_t>) + count_ * sizeof(std::atomic<int>);
    for (const std::size_t bytes : result_bytes) {
      constexpr std::size_t alignment = 64;
      offsets_.push_back((end + alignment - 1) / alignment * alignment);
      end = offsets_.back() + bytes;
    }
    size_ = end;
    void* memory = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    bytes_ = static_cast<char*>(memory);
    new (bytes_) std::atomic<std::size_t>(0);
    for (std::size_t i = 0; i < count_; ++i) new (&state(i)) std::atomic<int>(kUntouched);
  }
  ~SharedMemory() { munmap(bytes_, size_); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  std::size_t count() const { return count_; }
  std::atomic<std::size_t>& next() { return *reinterpret_cast<std::atomic<std::size_t>*>(bytes_); }
  std::atomic<int>& state(std::size_t task) {
    return reinterpret_cast<std::atomic<int>*>(bytes_ + sizeof(std::atomic<std::size_t>))[task];
  }
  char* result(std::size_t task) { return bytes_ + offsets_[task]; }

 private:
  std::size_t count_, size_ = 0;
  std::vector<std::size_t> offsets_;
  char* bytes_ = nullptr;
};
static_assert(std::atomic<std::size_t>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void work_through(SharedMemory& memory, const std::function<bool(std::size_t, char*)>& work) {
  while (true) {
    const std::size_t task = memory.next()++;
    if (task >= memory.count()) return;
    memory.state(task) = kBegun;
    bool is_done = false;
    try {
      is_done = work(task, memory.result(task));
    } catch (...) {  // as good as false: the parent says what could not be done
    }
    memory.state(task) = is_done ? kDone : kFailed;
  }
}

/// Quiet, without core dumps, gone when the parent is gone.
void settle_in_child(int cpu_seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN);  // the parent hears it, too, and stops after these tasks
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGXCPU}) std::signal(signal, SIG_DFL);
  const rlimit no_core = {0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const rlimit cpu = {static_cast<rlim_t>(cpu_seconds), static_cast<rlim_t>(cpu_seconds)};
  setrlimit(RLIMIT_CPU, &cpu);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

/// Forks that many children and waits for them; returns how many there were.
std::size_t run_children(std::size_t count, SharedMemory& memory, const std::function<bool(std::size_t, char*)>& work,
                         int cpu_seconds) {
  std::vector<pid_t> children;
  for (std::size_t i = 0; i < count; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      settle_in_child(cpu_seconds);
      work_through(memory, work);
      _exit(0);
    }
    if (child > 0) children.push_back(child);
  }
  for (const pid_t child : children)
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
  return children.size();
}

}  // namespace

std::vector<std::vector<char>> run_in_children(const std::vector<std::size_t>& result_bytes,
                                               const std::function<bool(std::size_t, char*)>& work, int cpu_seconds) {
  SharedMemory memory(result_bytes);
  const auto most = static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
  while (memory.next() < memory.count()) {  // again when all children died on the way
    const std::size_t left = memory.count() - memory.next();
    if (run_children(std::min(most, left), memory, work, cpu_seconds) == 0) throw std::bad_alloc();
  }
  std::vector<std::vector<char>> results(memory.count());
  for (std::size_t i = 0; i < results.size(); ++i)
    if (memory.state(i) == kDone) results[i].assign(memory.result(i), memory.result(i) + result_bytes[i]);
  return results;
}

}  // namespace isostack
