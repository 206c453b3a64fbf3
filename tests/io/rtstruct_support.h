#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/io/dicom_bytes.h"

namespace isostack::testing {

/// A contour as a file holds it. Without a type the element is left out.
struct FileContour {
  std::string type;
  std::vector<Eigen::Vector3d> points_mm;
};

struct FileRoi {
  std::string name, type, color;
  std::vector<FileContour> contours;
};

/// A structure set of these ROIs and nothing that need not be in one.
inline DicomBytes structure_set(const std::vector<FileRoi>& rois) {
  std::vector<DicomBytes> names, contours, observations;
  for (std::size_t i = 0; i < rois.size(); ++i) {
    const std::string number = std::to_string(10 + i);
    names.emplace_back().text(0x30060022, "IS", number).text(0x30060026, "LO", rois[i].name);
    DicomBytes& roi = contours.emplace_back().text(0x30060084, "IS", number);
    if (!rois[i].color.empty()) roi.text(0x3006002a, "IS", rois[i].color);
    std::vector<DicomBytes> items;
    for (const FileContour& contour : rois[i].contours) {
      DicomBytes& item = items.emplace_back().text(0x30060042, "CS", contour.type);
      std::vector<double> coordinates;
      for (const Eigen::Vector3d& point : contour.points_mm)
        coordinates.insert(coordinates.end(), point.data(), point.data() + 3);
      if (!coordinates.empty()) item.text(0x30060050, "DS", decimals(coordinates));
    }
    if (!items.empty()) roi.sequence(0x30060040, items);
    observations.emplace_back().text(0x30060084, "IS", number).text(0x300600a4, "CS", rois[i].type);
  }
  DicomBytes data;
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.481.3").text(0x00080018, "UI", "2.25.1");
  data.text(0x00080060, "CS", "RTSTRUCT");
  data.sequence(0x30060020, names).sequence(0x30060039, contours).sequence(0x30060080, observations);
  return data;
}

}  // namespace isostack::testing
