#include "viewers/scene_look.h"

namespace isostack {

SceneLook facing(const SlicePose& pose, SceneLook look) {
  look.view_from = -pose.normal();
  look.view_up = -pose.y_axis;
  return look;
}

}  // namespace isostack
