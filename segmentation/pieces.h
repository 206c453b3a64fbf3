#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace isostack {

/// Fixed pieces of a range, whatever the number of threads: results kept per piece and combined in order are the same.
struct Pieces {
  std::size_t count, length;

  std::size_t number() const { return (count + length - 1) / length; }

  /// body(piece, first, last) for every piece, in parallel when there are several.
  template <class Body>
  void for_each(Body body) const {
    const auto run = [&](std::size_t i) { body(i, i * length, std::min(count, (i + 1) * length)); };
    if (number() == 1) run(0);
    if (number() > 1) tbb::parallel_for(std::size_t{0}, number(), run);
  }
};

}  // namespace isostack
