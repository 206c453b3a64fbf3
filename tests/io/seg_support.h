#pragma once

#include <string>
#include <vector>

#include "tests/io/dicom_bytes.h"

namespace isostack::testing {

/// One frame of a segmentation of 5 x 3 pixels of 2 x 3 mm: its segment, height and pixels row by row, '#' is inside.
struct TestFrame {
  int segment;
  double z_mm;
  std::string pixels;
};

inline DicomBytes segment_item(int number, const std::string& label) {
  DicomBytes item;
  return item.us(0x00620004, static_cast<std::uint64_t>(number)).text(0x00620005, "LO", label);
}

inline DicomBytes frame_item(const TestFrame& frame) {
  DicomBytes position, identification, item;
  position.text(0x00200032, "DS", decimals({-10, -20, frame.z_mm}));
  item.sequence(0x00209113, {position});
  if (frame.segment > 0) {
    identification.us(0x0062000b, static_cast<std::uint64_t>(frame.segment));
    item.sequence(0x0062000a, {identification});
  }
  return item;
}

inline DicomBytes shared_item(double spacing_mm) {
  DicomBytes orientation, measures, item;
  orientation.text(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
  measures.text(0x00280030, "DS", "3\\2").text(0x00180050, "DS", decimals({spacing_mm}));
  measures.text(0x00180088, "DS", decimals({spacing_mm}));
  return item.sequence(0x00209116, {orientation}).sequence(0x00289110, {measures});
}

inline std::string packed(const std::vector<TestFrame>& frames) {
  std::string bytes(((frames.size() * 15 + 7) / 8 + 1) / 2 * 2, '\0');
  std::size_t bit = 0;
  for (const TestFrame& frame : frames)
    for (const char pixel : frame.pixels) {
      if (pixel == '#') bytes[bit / 8] = static_cast<char>(bytes[bit / 8] | 1 << bit % 8);
      ++bit;
    }
  return bytes;
}

/// A segmentation of one-bit pixels with segments 1 "one" and 2 "two".
inline DicomBytes segmentation(const std::vector<TestFrame>& frames, double spacing_mm = 4) {
  DicomBytes data;
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.4").text(0x00080018, "UI", "1.2.3.4.5");
  data.text(0x00080060, "CS", "SEG").text(0x0020000d, "UI", "1.2.3").text(0x0020000e, "UI", "1.2.3.4");
  data.us(0x00280002, 1).text(0x00280004, "CS", "MONOCHROME2").text(0x00280008, "IS", std::to_string(frames.size()));
  data.us(0x00280010, 3).us(0x00280011, 5).us(0x00280100, 1).us(0x00280101, 1).us(0x00280102, 0).us(0x00280103, 0);
  data.text(0x00620001, "CS", "BINARY").sequence(0x00620002, {segment_item(1, "one"), segment_item(2, "two")});
  data.sequence(0x52009229, {shared_item(spacing_mm)});
  std::vector<DicomBytes> items;
  for (const TestFrame& frame : frames) items.push_back(frame_item(frame));
  data.sequence(0x52009230, items).set(0x7fe00010, "OB", packed(frames), 1);
  return data;
}

/// The same with one byte per pixel: what `value` gives for the character.
inline DicomBytes with_bytes(DicomBytes data, const std::vector<TestFrame>& frames, char (*value)(char)) {
  std::string bytes;
  for (const TestFrame& frame : frames)
    for (const char pixel : frame.pixels) bytes += value(pixel);
  bytes.resize((bytes.size() + 1) / 2 * 2);
  return data.us(0x00280100, 8).us(0x00280101, 8).us(0x00280102, 7).set(0x7fe00010, "OB", bytes, 1);
}

inline const std::string dot = "......#........", other = "..............#";

}  // namespace isostack::testing
