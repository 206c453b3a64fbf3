#pragma once

#include "recon/kernels/kernel.h"

namespace isostack {

/// φ(√(r² + shift²)) of a distance r in at most three dimensions. The shift is the fixed distance
/// in all further dimensions between two layers of points; 0 gives the plain kernel.
struct RadialFunction {
  Kernel kernel;
  double shift_squared = 0;
};

}  // namespace isostack
