#include "cli/pipeline/step_order.h"

#include <algorithm>

#include "cli/pipeline/step_paths.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

std::vector<std::size_t> step_order(const Pipeline& pipeline, const std::vector<std::vector<std::string>>& reads) {
  const std::size_t count = pipeline.steps.size();
  std::vector<std::size_t> order;
  std::vector<bool> done(count);
  const auto waits = [&](std::size_t step) {
    return std::any_of(reads[step].begin(), reads[step].end(), [&](const std::string& path) {
      for (std::size_t other = 0; other < count; ++other)
        if (!done[other] && writes_path(pipeline.steps[other], path)) return true;
      return false;
    });
  };
  while (order.size() < count) {
    std::size_t next = 0;
    while (next < count && (done[next] || waits(next))) ++next;
    if (next == count) {
      std::string names;
      for (std::size_t i = 0; i < count; ++i)
        if (!done[i]) names += (names.empty() ? "" : ", ") + pipeline.steps[i].name;
      const auto first = static_cast<std::size_t>(std::find(done.begin(), done.end(), false) - done.begin());
      throw InputError(pipeline.steps[first].where, "steps wait for each other's files in a circle: " + names,
                       "let one of them read another file");
    }
    done[next] = true;
    order.push_back(next);
  }
  return order;
}

}  // namespace isostack::cli
