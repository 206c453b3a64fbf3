// rival_itk_level_set MATRIX slices|volume THREADS RMS REGION: ITK's sparse-field threshold segmentation, the slices
// one by one on THREADS threads, or the volume by the parallel sparse field. Writes the region as bytes. A rival to
// measure against only; nothing of the product is linked to ITK.
#include <itkImage.h>
#include <itkMultiThreaderBase.h>
#include <itkParallelSparseFieldLevelSetImageFilter.h>
#include <itkThresholdSegmentationLevelSetFunction.h>
#include <itkThresholdSegmentationLevelSetImageFilter.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "tests/benchmarks/head_ct.h"

namespace {

using isostack::benchmarks::HeadCt;

template <unsigned D>
typename itk::Image<float, D>::Pointer image_on(const unsigned (&size)[3]) {
  auto image = itk::Image<float, D>::New();
  typename itk::Image<float, D>::RegionType region;
  for (unsigned axis = 0; axis < D; ++axis) region.SetSize(axis, size[axis]);
  image->SetRegions(region);
  image->SetSpacing(HeadCt::spacing_mm);
  image->Allocate();
  return image;
}

/// Grey values, and the start: negative inside.
template <class Image>
void fill(const HeadCt& head, std::size_t first, std::size_t count, Image& grey, Image& start) {
  for (std::size_t i = 0; i < count; ++i) {
    grey.GetBufferPointer()[i] = head.voxels[first + i];
    start.GetBufferPointer()[i] = HeadCt::is_bone(head.voxels[first + i]) ? -0.5f : 0.5f;
  }
}

template <class Image>
void keep_region(const Image& phi, std::size_t first, std::size_t count, std::vector<std::uint8_t>& region) {
  for (std::size_t i = 0; i < count; ++i) region[first + i] = phi.GetBufferPointer()[i] <= 0;
}

constexpr unsigned size[3] = {HeadCt::columns, HeadCt::rows, HeadCt::slices};

int segment_slice(const HeadCt& head, std::size_t k, double rms, std::vector<std::uint8_t>& region) {
  using Image = itk::Image<float, 2>;
  const auto grey = image_on<2>(size), start = image_on<2>(size);
  fill(head, k * HeadCt::slice_size, HeadCt::slice_size, *grey, *start);
  const auto filter = itk::ThresholdSegmentationLevelSetImageFilter<Image, Image>::New();
  filter->SetInput(start);
  filter->SetFeatureImage(grey);
  filter->SetLowerThreshold(HeadCt::lower);
  filter->SetUpperThreshold(HeadCt::upper);
  filter->SetCurvatureScaling(HeadCt::curvature);
  filter->SetPropagationScaling(1);
  filter->SetMaximumRMSError(rms);
  filter->SetNumberOfIterations(HeadCt::max_steps);
  filter->SetNumberOfLayers(HeadCt::layers);
  filter->Update();
  keep_region(*filter->GetOutput(), k * HeadCt::slice_size, HeadCt::slice_size, region);
  return static_cast<int>(filter->GetElapsedIterations());
}

using Volume = itk::Image<float, 3>;

/// The filter's constructor is for derived classes only.
class ParallelFilter : public itk::ParallelSparseFieldLevelSetImageFilter<Volume, Volume> {
 public:
  using Self = ParallelFilter;
  using Superclass = itk::ParallelSparseFieldLevelSetImageFilter<Volume, Volume>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  itkNewMacro(Self);
};

int segment_volume(const HeadCt& head, int threads, double rms, std::vector<std::uint8_t>& region) {
  const auto grey = image_on<3>(size), start = image_on<3>(size);
  fill(head, 0, head.voxels.size(), *grey, *start);
  const auto speed = itk::ThresholdSegmentationLevelSetFunction<Volume, Volume>::New();
  Volume::SizeType radius;
  radius.Fill(1);
  speed->Initialize(radius);  // sets weights of its own
  speed->SetFeatureImage(grey);
  speed->SetLowerThreshold(HeadCt::lower);
  speed->SetUpperThreshold(HeadCt::upper);
  speed->SetCurvatureWeight(HeadCt::curvature);
  speed->SetPropagationWeight(1);
  speed->AllocateSpeedImage();
  speed->CalculateSpeedImage();
  const auto filter = ParallelFilter::New();
  filter->SetDifferenceFunction(speed);
  filter->SetInput(start);
  filter->SetMaximumRMSError(rms);
  filter->SetNumberOfIterations(HeadCt::max_steps);
  filter->SetNumberOfLayers(HeadCt::layers);
  filter->SetNumberOfWorkUnits(static_cast<unsigned>(threads));
  filter->Update();
  keep_region(*filter->GetOutput(), 0, head.voxels.size(), region);
  return static_cast<int>(filter->GetElapsedIterations());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  const auto head = isostack::benchmarks::read_head_ct(argv[1]);
  if (head.voxels.empty()) return 3;
  const bool is_volume = std::strcmp(argv[2], "volume") == 0;
  const int threads = std::max(1, std::atoi(argv[3]));
  const double rms = std::atof(argv[4]);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(is_volume ? static_cast<unsigned>(threads) : 1);
  std::vector<std::uint8_t> region(head.voxels.size());
  std::atomic<int> steps = 0;
  std::atomic<std::size_t> next = 0;
  const isostack::Stopwatch watch;
  if (is_volume) {
    steps = segment_volume(head, threads, rms, region);
  } else {
    std::vector<std::thread> workers;
    for (int i = 0; i < threads; ++i)
      workers.emplace_back([&] {
        for (std::size_t k = next++; k < HeadCt::slices; k = next++) steps += segment_slice(head, k, rms, region);
      });
    for (auto& worker : workers) worker.join();
  }
  std::printf("seconds %.3f\nsteps %d\npeak_gb %.2f\n", watch.seconds(), steps.load(),
              static_cast<double>(isostack::peak_memory_bytes()) / 1e9);
  std::ofstream(argv[5], std::ios::binary)
      .write(reinterpret_cast<const char*>(region.data()), static_cast<std::streamsize>(region.size()));
  return 0;
}
