// rival_vtk_distance MESH N: vtkImplicitPolyDataDistance on the voxels of the band that distance_volumes scans at N³.
#include <vtkDataArray.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: rival_vtk_distance MESH.obj N\n", stderr);
    return 2;
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  const int n = std::atoi(argv[2]);
  double b[6];
  reader->GetOutput()->GetBounds(b);
  const double longest = std::max({b[1] - b[0], b[3] - b[2], b[5] - b[4]}), step = longest / (n - 9);
  const auto start = std::chrono::steady_clock::now();
  vtkNew<vtkImplicitPolyDataDistance> distance;
  distance->SetInput(reader->GetOutput());
  long voxels = 0, in_band = 0;
  // Every 64th voxel, in rows: all of them take minutes.
  for (int k = 0; k < n; k += 8)
    for (int j = 0; j < n; j += 8)
      for (int i = 0; i < n; ++i, ++voxels) {
        double p[3] = {0.5 * (b[0] + b[1]) + step * (i - 0.5 * (n - 1)),
                       0.5 * (b[2] + b[3]) + step * (j - 0.5 * (n - 1)),
                       0.5 * (b[4] + b[5]) + step * (k - 0.5 * (n - 1))};
        if (std::abs(distance->EvaluateFunction(p)) <= 3 * step) ++in_band;
      }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("vtkImplicitPolyDataDistance %d^3, one thread: %ld voxels (%ld in the band) in %.3f s, %.2f us each\n", n,
              voxels, in_band, seconds, 1e6 * seconds / static_cast<double>(voxels));
  return 0;
}
