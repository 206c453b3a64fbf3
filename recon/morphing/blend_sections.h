#pragma once

#include <memory>
#include <vector>

#include "recon/functions/solid_function.h"
#include "recon/functions/space_time.h"
#include "recon/morphing/key_places.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/shape.h"

namespace isostack {

// The two halves of a blend morph: shapes -> functions of space-time, functions -> frames.

/// Between two neighbouring key shapes.
struct BlendedPair {
  SolidFunction space_time;  ///< of the shapes' coordinates and time, mm from the first of the two
  TimeSpan changing_mm;      ///< before and after it sections are the key shapes themselves
};

/// A morph on a line of times.
struct BlendedMorph {
  std::vector<KeyShape> shapes;
  std::vector<BlendedPair> pairs;  ///< one fewer than shapes
  KeyPlaces places;
  double length_mm = 0;  ///< from one key shape to the next, in space-time
  double resolution_mm = 0;
};

std::shared_ptr<const MorphMethod> blend_sections(BlendedMorph morph);

}  // namespace isostack
