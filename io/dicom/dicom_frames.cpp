#include "io/dicom/dicom_frames.h"

#include <fmt/format.h>
#include <gdcmDataSet.h>

#include <Eigen/Geometry>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr DicomTag shared_groups = 0x52009229, per_frame_groups = 0x52009230;

template <class T>
void keep(std::optional<T>& target, const std::optional<T>& found) {
  if (found) target = found;
}

void read_timing(const gdcm::DataSet& data, DicomTiming& timing) {
  keep(timing.temporal_position, dicom_number(data, 0x00200100));
  keep(timing.trigger_time_ms, dicom_number(data, 0x00181060));
  keep(timing.echo_time_ms, dicom_number(data, 0x00180081));
  keep(timing.instance_number, dicom_number(data, 0x00200013));
  keep(timing.acquisition_s, dicom_seconds(dicom_text(data, 0x00080022), dicom_text(data, 0x00080032)));
  if (const std::string both = dicom_text(data, 0x0008002a); both.size() > 8)
    keep(timing.acquisition_s, dicom_seconds(both.substr(0, 8), both.substr(8)));
}

/// FrameContentSequence, CardiacSynchronizationSequence and MREchoSequence of enhanced images.
void read_group_timing(const gdcm::DataSet& groups, DicomTiming& timing) {
  for (const gdcm::DataSet& content : dicom_items(groups, 0x00209111)) {
    keep(timing.temporal_position, dicom_uint32(content, 0x00209128));
    if (const std::string both = dicom_text(content, 0x00189074); both.size() > 8)
      keep(timing.acquisition_s, dicom_seconds(both.substr(0, 8), both.substr(8)));
  }
  for (const gdcm::DataSet& cardiac : dicom_items(groups, 0x00189118))
    keep(timing.trigger_time_ms, dicom_float64(cardiac, 0x00209153));
  for (const gdcm::DataSet& echo : dicom_items(groups, 0x00189114))
    keep(timing.echo_time_ms, dicom_float64(echo, 0x00189082));
}

/// One item of the functional groups: each group is a sequence of one item.
void read_groups(const gdcm::DataSet& groups, DicomFrame& frame) {
  constexpr DicomTag plane_position = 0x00209113, plane_orientation = 0x00209116, pixel_measures = 0x00289110,
                     value_transformation = 0x00289145;
  for (const DicomTag group : {plane_position, plane_orientation, pixel_measures, value_transformation})
    for (const gdcm::DataSet& data : dicom_items(groups, group)) read_frame_part(data, frame);
  read_group_timing(groups, frame.timing);
}

std::vector<DicomFrame> enhanced_frames(const gdcm::DataSet& data, const DicomHeader& whole) {
  const std::vector<gdcm::DataSet> per_frame = dicom_items(data, per_frame_groups);
  if (per_frame.size() != static_cast<std::size_t>(whole.frames))
    throw InputError(whole.name, fmt::format("it claims {} frames but describes {}", whole.frames, per_frame.size()),
                     "the file is cut off or damaged; copy it again or take it out");
  DicomFrame shared = whole;
  for (const gdcm::DataSet& groups : dicom_items(data, shared_groups)) read_groups(groups, shared);
  std::vector<DicomFrame> frames(per_frame.size(), shared);
  for (std::size_t i = 0; i < frames.size(); ++i) read_groups(per_frame[i], frames[i]);
  return frames;
}

/// RT Dose: planes at these distances along the normal from the first one.
std::vector<DicomFrame> dose_frames(const std::vector<double>& offsets_mm, const DicomHeader& whole) {
  if (offsets_mm.size() != static_cast<std::size_t>(whole.frames) || offsets_mm.front() != 0 || !whole.position_mm ||
      !whole.row_and_column)
    return {};
  const Eigen::Vector3d normal = whole.row_and_column->first.cross(whole.row_and_column->second);
  std::vector<DicomFrame> frames(offsets_mm.size(), whole);
  for (std::size_t i = 0; i < frames.size(); ++i) *frames[i].position_mm += offsets_mm[i] * normal;
  return frames;
}

}  // namespace

void read_frame_part(const gdcm::DataSet& data, DicomFrame& frame) {
  if (const auto p = dicom_numbers(data, 0x00200032); p.size() == 3) frame.position_mm = {p[0], p[1], p[2]};
  if (const auto o = dicom_numbers(data, 0x00200037); o.size() == 6)
    frame.row_and_column = {{o[0], o[1], o[2]}, {o[3], o[4], o[5]}};
  // DICOM gives the distance between rows (along y) first.
  if (const auto s = dicom_numbers(data, 0x00280030); s.size() == 2) frame.spacing_mm = {s[1], s[0]};
  keep(frame.slice_thickness_mm, dicom_number(data, 0x00180050));
  keep(frame.spacing_between_slices_mm, dicom_number(data, 0x00180088));
  frame.slope = dicom_number(data, 0x00281053).value_or(frame.slope);
  frame.intercept = dicom_number(data, 0x00281052).value_or(frame.intercept);
  read_timing(data, frame.timing);
}

std::vector<DicomFrame> read_frame_parts(const gdcm::DataSet& data, const DicomHeader& whole) {
  if (!dicom_items(data, per_frame_groups).empty()) return enhanced_frames(data, whole);
  const std::vector<double> offsets_mm = dicom_numbers(data, 0x3004000c);
  if (whole.frames > 1 && !offsets_mm.empty()) return dose_frames(offsets_mm, whole);
  return {};
}

std::vector<DicomHeader> frames_of(const DicomHeader& header) {
  if (header.frame_parts.empty() && header.frames == 1) return {header};
  if (header.frame_parts.empty())
    throw InputError(header.name,
                     fmt::format("the file holds {} frames and does not say where they lie", header.frames),
                     "convert it to one file per slice with positions, or to NIfTI");
  DicomHeader common = header;
  common.frame_parts.clear();
  std::vector<DicomHeader> frames(header.frame_parts.size(), common);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    static_cast<DicomFrame&>(frames[i]) = header.frame_parts[i];
    frames[i].frame = static_cast<int>(i);
    if (frames.size() > 1) frames[i].name += fmt::format(" frame {}", i + 1);
  }
  return frames;
}

}  // namespace isostack
