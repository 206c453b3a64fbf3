#pragma once

#include "recon/subdivision/surface_domain.h"

namespace isostack {

/// A closed surface of genus 1 drawn on the unit square's torus: two loops that cut it open become the periods, every
/// vertex the mean of its neighbours (Gortler, Gotsman & Thurston 2006: one to one). Triangles with corners −1 are
/// left out; corners are numbered below `vertices`. Meant for few triangles: the solve is dense.
DomainMesh torus_start(const std::vector<Eigen::Vector3i>& triangles, int vertices);

}  // namespace isostack
