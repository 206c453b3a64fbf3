#include "python/bindings.h"
#include "python/sequences.h"
#include "python/struct_class.h"
#include "recon/geometry/label_map.h"

namespace isostack::python {

namespace {

LabelMap make_map(std::vector<LabelVolume> layers, std::vector<Segment> segments, std::vector<std::string> warnings) {
  for (const LabelVolume& layer : layers)
    if (layer.grid.size != layers.front().grid.size)
      throw InputError("layers", "they lie on different grids", "give layers of one grid");
  for (const Segment& segment : segments)
    if (segment.layer >= layers.size())
      throw InputError("segment " + segment.name, "there is no layer " + std::to_string(segment.layer),
                       "number the layers from 0");
  return {std::move(layers), std::move(segments), std::move(warnings)};
}

}  // namespace

void bind_labels(py::module_& core) {
  StructClass<Segment>(core, "Segment", "One organ of a label map: the voxels of one layer that hold its value.\n")
      .field("name", &Segment::name, "of the organ")
      .field("value", &Segment::value, "1 to 65535; 0 is background")
      .field("layer", &Segment::layer, "index into LabelMap.layers")
      .field("color", &Segment::color, "(red, green, blue), 0 to 255, or None")
      .done();
  py::class_<LabelMap> map(core, "LabelMap",
                           "Organs as voxels. One layer is enough unless organs overlap; all layers share one grid.");
  map.def(py::init(&make_map), py::arg("layers"), py::arg("segments") = std::vector<Segment>(),
          py::arg("warnings") = std::vector<std::string>(), "The layers are copied.");
  map.def_property_readonly(
      "layers", [](const py::object& self) { return references(self.cast<LabelMap&>().layers, self); },
      "the label volumes themselves, not copies");
  map.def_property_readonly(
      "segments", [](const LabelMap& self) { return copies(self.segments); }, "organs with a name; copies");
  map.def_property_readonly(
      "all_segments", [](const LabelMap& self) { return copies(all_segments(self)); },
      "every organ: those with a name, then values that none has, each with its number as name");
  map.def(
      "chosen_segments",
      [](const LabelMap& self, const std::string& choice, const std::string& where) {
        return copies(chosen_segments(self, choice, where));
      },
      py::arg("choice"), py::arg("where") = "labels",
      "The organs of that name, else those with that number; every one for \"all\". Raises InputError naming `where` "
      "and listing the organs present.");
  map.def_property_readonly(
      "warnings", [](const LabelMap& self) { return copies(self.warnings); },
      "what a user must know before trusting the map");
  map.def(
      "with_segment",
      [](LabelMap self, const LabelVolume& mask, const Segment& segment) {
        if (!self.layers.empty() && mask.grid.size != self.layers.front().grid.size)
          throw InputError("mask", "it lies on another grid than the map", "make it on the map's grid");
        add_segment(self, mask, segment);
        return self;
      },
      py::arg("mask"), py::arg("segment"),
      "A map with the voxels of the mask that are not 0 as one more organ, in a layer where it overlaps no other.");
  map.def(
      "flattened", [](const LabelMap& self) { return flattened(self); },
      "A map with one layer, for formats that hold no more: where organs overlap, the later has the voxel.");
  map.def("__repr__", [](const LabelMap& self) {
    return "<LabelMap, " + std::to_string(self.layers.size()) + " layers, " +
           std::to_string(all_segments(self).size()) + " organs>";
  });
}

}  // namespace isostack::python
