#include "python/bindings.h"
#include "python/struct_class.h"
#include "recon/geometry/errors.h"
#include "segmentation/organ_rules.h"
#include "segmentation/segment.h"

namespace isostack::python {

/// A step as a text.
template <>
struct ItemReader<StartStep> {
  static StartStep read(const py::handle& item) {
    return py::isinstance<py::str>(item) ? parse_start_step(py::cast<std::string>(item)) : py::cast<StartStep>(item);
  }
};

/// A seed as (x, y, z) or (x, y, z, name).
template <>
struct ItemReader<Seed> {
  static Seed read(const py::handle& item) {
    if (py::isinstance<Seed>(item)) return py::cast<Seed>(item);
    const py::tuple parts(py::reinterpret_borrow<py::object>(item));
    if (parts.size() != 3 && parts.size() != 4) throw py::cast_error("a seed has three coordinates and perhaps a name");
    Seed seed;
    for (int axis = 0; axis < 3; ++axis)
      seed.position_mm[axis] = py::cast<double>(parts[static_cast<std::size_t>(axis)]);
    if (parts.size() == 4) seed.name = py::cast<std::string>(parts[3]);
    return seed;
  }
};

namespace {

void bind_steps(py::module_& core) {
  StructClass<Seed>(core, "Seed", "A point within an organ.\n")
      .field("position_mm", &Seed::position_mm, "world LPS mm")
      .field("name", &Seed::name, "seeds of one name belong to one organ; \"-\": something that is not wanted")
      .done();
  py::class_<StartStep> step(
      core, "StartStep",
      "One step that finds where an evolution starts, from text. Positions are world LPS mm.\n\n"
      "    gaussian:SIGMA (pixels), diffusion:CONTRAST[,STEPS], level:V, darker:V, range:LO,HI,\n"
      "    otsu[:SHARE], otsu-darker[:SHARE], like-seeds[:SPREAD],\n"
      "    {add,keep,remove}-sphere:X,Y,Z,R, -box:X,Y,Z,DX,DY,DZ, -ellipsoid:X,Y,Z,RX,RY,RZ,\n"
      "    connected, grow:MM, shrink:MM, open:MM, close:MM, fill-holes, hull, largest");
  step.def(py::init(&parse_start_step), py::arg("text"));
  step.def_static(
      "labels",
      [](const Volume<float>& labels, int label) {
        return StartStep(LabelStep{std::make_shared<const Volume<float>>(labels), label});
      },
      py::arg("labels"), py::arg("label") = 0, "The voxels that hold the label (all but 0 when 0), nearest voxel.");
}

void bind_evolution(py::module_& core) {
  using E = EvolutionOptions;
  StructClass<E>(core, "EvolutionOptions",
                 "Weights of the level set's terms after the start; 0: the term is absent. Without any of curvature, "
                 "region, edge and balloon the start is the result. Pixels: the smallest spacing.\n")
      .field("curvature", &E::curvature, "of the curvature term, pixels")
      .field("range_weight", &E::range_weight,
             "of the term that seeks the rule's level; None: 1, or 0 where region or edge take its place")
      .field("region", &E::region, "of the region term (two means)")
      .field("region_window_mm", &E::region_window_mm, "its means are local; 0: over the whole slice or volume")
      .field("edge", &E::edge, "of the edge term, pixels")
      .field("edge_contrast", &E::edge_contrast, "grey values per mm; 0: estimated")
      .field("balloon", &E::balloon, "above 0 grows, below 0 shrinks; stopped by edges when edge > 0")
      .field("stay_mm", &E::stay_mm, "above 0: the result exceeds the start by no more than this, mm")
      .field("max_steps", &E::max_steps, "at most")
      .done();
}

template <class Options>
StructClass<Options> with_common(StructClass<Options> options) {
  return options
      .field("propagate_mm", &Options::propagate_mm,
             "above 0: from the seeds' slices outwards, each at most this much beyond the one before, mm")
      .field("in_volume", &Options::in_volume, "motions and evolution in 3D; needs evenly spaced slices")
      .field("evolution", &Options::evolution, "the level set that follows the start");
}

void bind_rules(py::module_& core) {
  using R = OrganRules;
  with_common(
      StructClass<R>(core, "OrganRules",
                     "Where organs are in grey images: at most one rule of grey values (level, range, otsu, spread), "
                     "filters before it, clean-up after it, in a fixed order. As the command's options.\n")
          .field("level", &R::level, "the organ is at least this bright (CT: HU)")
          .field("darker", &R::darker, "the organ is at most as bright as the level")
          .field("range", &R::range, "(low, high): grey values between these")
          .field("otsu", &R::otsu, "brighter than Otsu's level")
          .field("otsu_darker", &R::otsu_darker, "darker than Otsu's level")
          .field("seeds", &R::seeds, "points of the organs, world LPS mm: Seed, (x, y, z) or (x, y, z, name)")
          .field("spread", &R::spread, "seeds without another rule: standard deviations round their grey values (2.5)")
          .field("gaussian_sigma_pixels", &R::gaussian_sigma_pixels, "low-pass filter; 0: none")
          .field("diffusion", &R::diffusion, "edge-keeping filter")
          .field("start", &R::start, "further steps after the rule: StartStep or its text")
          .field("open_mm", &R::open_mm, "parts what hangs together by less than twice this, mm")
          .field("close_mm", &R::close_mm, "fills gaps narrower than twice this, mm")
          .field("hull", &R::hull, "every part becomes its convex hull, slice by slice")
          .field("fill_holes", &R::fill_holes, "per slice: background enclosed by the organ becomes organ")
          .field("largest", &R::largest, "the largest connected part only"))
      .done();
}

}  // namespace

void bind_segmentation_options(py::module_& core) {
  bind_steps(core);
  StructClass<DiffusionOptions>(core, "DiffusionOptions", "Anisotropic diffusion (Perona and Malik 1990).\n")
      .field("contrast", &DiffusionOptions::contrast, "grey steps between pixels well above it stay; > 0")
      .field("steps", &DiffusionOptions::steps, "each smooths flat regions like a Gaussian of about 0.7 pixel")
      .done();
  bind_evolution(core);
  bind_rules(core);
  with_common(StructClass<OrganOptions>(core, "OrganOptions", "The start step by step, instead of by OrganRules.\n")
                  .field("start", &OrganOptions::start, "filters, then a rule, then what changes the region")
                  .field("seeds", &OrganOptions::seeds, "one organ per name; none: one organ"))
      .field("keep_distances", &OrganOptions::keep_distances, "also return the signed distances")
      .done();
  using S = SegmentationOptions;
  StructClass<S>(core, "SegmentationOptions",
                 "How grey slices become contours of one organ. Pixels: the smaller spacing.\n")
      .field("level", &S::level, "the organ is where the (filtered) image is at least this bright (CT: HU)")
      .field("brighter_inside", &S::brighter_inside, "False: the organ is darker than the level")
      .field("gaussian_sigma_pixels", &S::gaussian_sigma_pixels, "low-pass filter; 0: none")
      .field("curvature", &S::curvature, "weight of the curvature term, pixels; 0: exact level curves")
      .field("max_steps", &S::max_steps, "level-set steps at most, used when curvature > 0")
      .field("fill_holes", &S::fill_holes, "per slice: background that does not reach the border becomes organ")
      .field("largest", &S::largest, "only the largest 3D component over the stack")
      .done();
  StructClass<LabelOptions>(core, "LabelOptions", "How labels are traced.\n")
      .field("fill_holes", &LabelOptions::fill_holes, "as in SegmentationOptions")
      .field("largest", &LabelOptions::largest, "as in SegmentationOptions")
      .done();
  core.def("organ_options", &organ_options, py::arg("rules"), "The same start step by step.");
}

}  // namespace isostack::python
