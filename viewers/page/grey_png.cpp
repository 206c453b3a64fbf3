#include "viewers/page/grey_png.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "viewers/quiet_vtk.h"

namespace isostack {

std::vector<std::byte> grey_png(const Image<std::uint8_t>& pixels) {
  const QuietVtk quiet;
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(pixels.cols()), static_cast<int>(pixels.rows()), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  // VTK's rows come from the bottom.
  for (Eigen::Index row = 0; row < pixels.rows(); ++row)
    std::copy_n(pixels.data() + row * pixels.cols(), pixels.cols(),
                static_cast<std::uint8_t*>(image->GetScalarPointer(0, static_cast<int>(pixels.rows() - 1 - row), 0)));
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(image);
  writer->Write();
  vtkUnsignedCharArray& bytes = *writer->GetResult();
  const auto* first = reinterpret_cast<const std::byte*>(bytes.GetPointer(0));
  return {first, first + bytes.GetNumberOfValues()};
}

}  // namespace isostack
