#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "recon/geometry/slice.h"
#include "recon/geometry/volume.h"
#include "segmentation/diffusion.h"
#include "segmentation/solid.h"
#include "segmentation/threshold.h"

namespace isostack {

// The steps that find where the evolution starts (Breen et al. 2001, §4.3.1), applied one after the other.
// Filters come first; one rule then makes a region of the grey values; the others change that region.

/// Filter: Gaussian, standard deviation in (the smaller) pixels.
struct GaussianStep {
  double sigma_pixels = 1;
};
/// Filter: anisotropic diffusion.
struct DiffusionStep {
  DiffusionOptions options;
};
/// Rule: grey values in the range.
struct RangeStep {
  GreyRange range;
};
/// Rule: brighter (or darker) than Otsu's level of all slices, or than the level this share of the way from the mean of
/// the class outside to that of the class inside.
struct OtsuStep {
  bool brighter_inside = true;
  std::optional<double> share = std::nullopt;  ///< in (0, 1)
};
/// Rule: grey values within `spread` standard deviations of the mean around each organ's seeds.
struct SeedRangeStep {
  double spread = 2.5;
};
/// Rule: the voxels of a label map that hold `label` (all but 0 when 0), nearest voxel.
struct LabelStep {
  std::shared_ptr<const Volume<float>> labels;
  int label = 0;
};
/// Set operation with a solid; `add` as the first step is a rule, too.
struct SolidStep {
  enum class Operation { add, keep, remove };
  Operation operation = Operation::keep;
  Solid solid;
};
/// Keeps what is connected to the organ's seeds.
struct ConnectedStep {};
/// Morphological motion by a distance in mm: grow (negative: shrink), opening, closing.
struct GrowStep {
  double distance_mm = 0;
};
struct OpenStep {
  double radius_mm = 0;
};
struct CloseStep {
  double radius_mm = 0;
};
/// Per slice: background that does not reach the border becomes organ.
struct FillHolesStep {};
/// Per slice: every part becomes its convex hull.
struct HullStep {};
/// The largest 3D part of each organ.
struct LargestStep {};

using StartStep = std::variant<GaussianStep, DiffusionStep, RangeStep, OtsuStep, SeedRangeStep, LabelStep, SolidStep,
                               ConnectedStep, GrowStep, OpenStep, CloseStep, FillHolesStep, HullStep, LargestStep>;

bool is_filter(const StartStep& step);
bool is_rule(const StartStep& step);

/// One step from text. Positions are world LPS mm; a box is given by its centre and its edges.
///   gaussian:SIGMA (pixels) · diffusion:CONTRAST[,STEPS]
///   level:V · darker:V · range:LO,HI · otsu[:SHARE] · otsu-darker[:SHARE] · like-seeds[:SPREAD]
///   {add,keep,remove}-sphere:X,Y,Z,R · {...}-box:X,Y,Z,DX,DY,DZ · {...}-ellipsoid:X,Y,Z,RX,RY,RZ
///   connected · grow:MM · shrink:MM · open:MM · close:MM · fill-holes · hull · largest
/// Throws InputError naming the step and what it needs. (LabelStep has no text: it needs a volume.)
StartStep parse_start_step(const std::string& text);

}  // namespace isostack
