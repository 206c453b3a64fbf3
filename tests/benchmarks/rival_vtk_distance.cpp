// rival_vtk_distance MESH N: vtkImplicitPolyDataDistance on all voxels of the band that distance_volumes scans at N³,
// on one thread and on two, each with an instance of its own: it keeps state between calls.
#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

using Point = std::array<double, 3>;

/// Voxels whose distance is up to three voxels, among those near some triangle's box.
std::vector<Point> band_of(vtkPolyData* mesh, int n, double* step_mm) {
  double b[6];
  mesh->GetBounds(b);
  const double step = std::max({b[1] - b[0], b[3] - b[2], b[5] - b[4]}) / (n - 9);
  Point first{};
  for (int axis = 0; axis < 3; ++axis)
    first[static_cast<std::size_t>(axis)] = 0.5 * (b[2 * axis] + b[2 * axis + 1]) - 0.5 * step * (n - 1);
  std::vector<char> near(static_cast<std::size_t>(n) * n * n, 0);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell) {
    double box[6];
    mesh->GetCellBounds(cell, box);
    int low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double from = first[static_cast<std::size_t>(axis)];
      low[axis] = std::max(0, static_cast<int>(std::floor((box[2 * axis] - from) / step - 3)));
      high[axis] = std::min(n - 1, static_cast<int>(std::ceil((box[2 * axis + 1] - from) / step + 3)));
    }
    for (int k = low[2]; k <= high[2]; ++k)
      for (int j = low[1]; j <= high[1]; ++j)
        for (int i = low[0]; i <= high[0]; ++i) near[(static_cast<std::size_t>(k) * n + j) * n + i] = 1;
  }
  vtkNew<vtkImplicitPolyDataDistance> distance;
  distance->SetInput(mesh);
  std::vector<Point> band;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        if (near[(static_cast<std::size_t>(k) * n + j) * n + i] == 0) continue;
        Point p{first[0] + step * i, first[1] + step * j, first[2] + step * k};
        if (std::abs(distance->EvaluateFunction(p.data())) <= 3 * step) band.push_back(p);
      }
  *step_mm = step;
  return band;
}

/// The trees' building included.
double seconds_on(int threads, vtkPolyData* mesh, std::vector<Point> band) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::thread> pool;
  for (int t = 0; t < threads; ++t)
    pool.emplace_back([&, t] {
      vtkNew<vtkPolyData> own;
      own->DeepCopy(mesh);
      vtkNew<vtkImplicitPolyDataDistance> distance;
      distance->SetInput(own);
      const std::size_t begin = band.size() * static_cast<std::size_t>(t) / static_cast<std::size_t>(threads);
      const std::size_t end = band.size() * static_cast<std::size_t>(t + 1) / static_cast<std::size_t>(threads);
      for (std::size_t i = begin; i < end; ++i) distance->EvaluateFunction(band[i].data());
    });
  for (std::thread& thread : pool) thread.join();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: rival_vtk_distance MESH.obj N\n", stderr);
    return 2;
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  const int n = std::atoi(argv[2]);
  double step_mm = 0;
  const std::vector<Point> band = band_of(reader->GetOutput(), n, &step_mm);
  for (const int threads : {1, 2}) {
    const double seconds = seconds_on(threads, reader->GetOutput(), band);
    std::printf("vtkImplicitPolyDataDistance %d^3, %d thread(s): %zu voxels of the band in %.3f s, %.2f us each\n", n,
                threads, band.size(), seconds, 1e6 * seconds / static_cast<double>(band.size()));
  }
  return 0;
}
