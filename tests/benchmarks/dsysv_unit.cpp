// dsysv_unit: seconds LAPACK's dsysv takes for 10,000 constraints of the contour stack with kernel r, on all threads:
// the unit in which the solver's times are told. A process of its own, so that no other figure holds its memory.
#include <fmt/format.h>

#include <vector>

#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "tests/benchmarks/star_stack.h"

extern "C" {
void dsysv_(const char* uplo, const int* n, const int* columns, double* a, const int* lda, int* pivots, double* b,
            const int* ldb, double* work, const int* work_size, int* info);
__attribute__((weak)) char* openblas_get_config();
}

int main() {
  constexpr int count = 10'000, size = count + 4, one = 1, work_size = size * 64;
  const isostack::benchmarks::StarStack stack = isostack::benchmarks::star_stack(7);
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  right.head(count) = stack.values.head(count);
  for (int j = 0; j < count; ++j) {
    for (int i = j; i < count; ++i) system(i, j) = (stack.points.col(i) - stack.points.col(j)).norm() / 100;
    system(count, j) = 1;
    system.block(count + 1, j, 3, 1) = stack.points.col(j) / 100;
  }
  std::vector<int> pivots(size);
  std::vector<double> work(work_size);
  int info = 0;
  const isostack::Stopwatch watch;
  dsysv_("L", &size, &one, system.data(), &size, pivots.data(), right.data(), &size, work.data(), &work_size, &info);
  fmt::print("constraints {}\nseconds {:.2f}\npeak_gb {:.2f}\nblas {}\n", count, watch.seconds(),
             static_cast<double>(isostack::peak_memory_bytes()) / 1e9,
             openblas_get_config == nullptr ? "unknown" : openblas_get_config());
  return info == 0 ? 0 : 1;
}
