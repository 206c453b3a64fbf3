#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace isostack {

/// Throws InputError naming the file when it is cut off or damaged.
vtkSmartPointer<vtkPolyData> read_vtp(const std::filesystem::path& path);

/// Binary with double precision; whole file or none. Throws InputError naming the file.
void write_vtp(vtkPolyData& data, const std::filesystem::path& path);

}  // namespace isostack
