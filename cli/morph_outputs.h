#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/morph_frames.h"
#include "cli/morph_pictures.h"
#include "cli/session.h"
#include "recon/morphing/morph.h"

namespace isostack::cli {

/// Where frames go and as what. By the output's name: `.gif` an animation, `.png` a contact sheet, `.json` and `.vtp`
/// (figures) all contours as slices of one stack, other meshes the surface of figures in space-time or one file per
/// body; any other name a folder with one file per frame.
struct MorphOutputs {
  std::vector<std::filesystem::path> paths;
  std::string format;  ///< of the files in folders; empty: png of figures, stl of bodies
  MorphPictureOptions pictures;
  double frames_per_second = 12.5;
};

/// Throws InputError before any work is done when an output could not be written at the end.
void require_writable(const MorphOutputs& outputs);
/// The same, once it is known whether the frames will be figures (2) or bodies (3).
void require_fitting(const MorphOutputs& outputs, int dimension);

/// What the outputs need beyond the frames; parts that none needs are empty.
struct MorphProducts {
  std::vector<Picture> pictures;
  TriangleMesh spacetime;
  ContourStack slices;
};

/// Makes them. After that nothing is refused or stopped any more. Throws InputError as pictures_of() does, and when
/// the morph has no surface in space-time for an output to hold.
MorphProducts products_for(const std::vector<MorphFrame>& frames, const Morph& morph, const MorphOutputs& outputs,
                           const Progress& progress);

/// Writes all outputs, each whole or not at all, and names them in the result.
void write_outputs(const std::vector<MorphFrame>& frames, const MorphProducts& products, const MorphOutputs& outputs,
                   Session& session);

}  // namespace isostack::cli
