#include "recon/solvers/thread_count.h"

#include <oneapi/tbb/info.h>

#include <mutex>

// OpenBLAS has these entries; another BLAS need not, so they are looked up weakly.
extern "C" __attribute__((weak)) void openblas_set_num_threads(int count);
extern "C" __attribute__((weak)) int openblas_get_num_threads();

namespace isostack {

namespace {

/// The setting is of the whole process, which may solve several systems at once.
struct BlasSetting {
  std::mutex mutex;
  int users = 0, threads_before = 0;
};

BlasSetting& blas_setting() {
  static BlasSetting setting;
  return setting;
}

bool is_openblas() { return openblas_set_num_threads != nullptr && openblas_get_num_threads != nullptr; }

}  // namespace

int available_threads() { return tbb::info::default_concurrency(); }

OneBlasThread::OneBlasThread() {
  BlasSetting& setting = blas_setting();
  const std::lock_guard lock(setting.mutex);
  if (++setting.users > 1 || !is_openblas()) return;
  setting.threads_before = openblas_get_num_threads();
  openblas_set_num_threads(1);
}

OneBlasThread::~OneBlasThread() {
  BlasSetting& setting = blas_setting();
  const std::lock_guard lock(setting.mutex);
  if (--setting.users == 0 && is_openblas()) openblas_set_num_threads(setting.threads_before);
}

}  // namespace isostack
