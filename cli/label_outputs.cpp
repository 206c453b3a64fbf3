#include "cli/label_outputs.h"

#include <fmt/format.h>

#include "io/formats.h"
#include "io/volumes/volume_files.h"

namespace isostack::cli {

void write_organ_labels(const LabelMap& labels, const std::filesystem::path& output, const WriteOptions& options,
                        Session& session) {
  const Format& format = format_for(output, &Format::write_labels, "labels");
  if (format.labels_may_overlap || labels.layers.size() < 2) return write_labels(labels, output, options);
  std::size_t shared = 0;
  const LabelMap flat = flattened(labels, &shared);
  session.note(
      fmt::format("{}: organs overlap in {} voxels, which went to the later one; .seg.nrrd and DICOM SEG keep "
                  "both",
                  output.filename().string(), shared));
  write_labels(flat, output, options);
}

}  // namespace isostack::cli
