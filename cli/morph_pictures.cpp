#include "cli/morph_pictures.h"

#include "viewers/figure_picture.h"
#include "viewers/screenshot.h"

namespace isostack::cli {

namespace {

Picture white(int width, int height) {
  return {.width_pixels = width,
          .height_pixels = height,
          .rgb = std::vector<std::uint8_t>(
              std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255)};
}

std::vector<Picture> figures(const std::vector<MorphFrame>& frames, const MorphPictureOptions& options) {
  std::vector<std::vector<Contour>> contours;
  for (const MorphFrame& frame : frames) contours.push_back(frame.figure().contours);
  const PictureFrame view = frame_round(contours, options.size_pixels);
  std::vector<Picture> pictures;
  for (const std::vector<Contour>& figure : contours) pictures.push_back(draw_figure(figure, view));
  return pictures;
}

std::vector<Picture> bodies(const std::vector<MorphFrame>& frames, const MorphPictureOptions& options,
                            const Progress& progress) {
  ScreenshotOptions view{.width_pixels = options.size_pixels,
                         .height_pixels = options.size_pixels,
                         .look = {.view_from = options.view_from, .framed_points_mm = {}, .marks = false}};
  for (const MorphFrame& frame : frames)
    view.look.framed_points_mm.insert(view.look.framed_points_mm.end(), frame.body().vertices_mm.begin(),
                                      frame.body().vertices_mm.end());
  std::vector<Picture> pictures;
  for (const MorphFrame& frame : frames) {
    progress.report("pictures", static_cast<double>(pictures.size()) / static_cast<double>(frames.size()));
    pictures.push_back(frame.body().triangles.empty() ? white(view.width_pixels, view.height_pixels)
                                                      : draw_picture({.surfaces = {{.mesh = frame.body()}}}, view));
  }
  return pictures;
}

}  // namespace

std::vector<Picture> pictures_of(const std::vector<MorphFrame>& frames, const MorphPictureOptions& options,
                                 const Progress& progress) {
  return frames.front().is_figure() ? figures(frames, options) : bodies(frames, options, progress);
}

}  // namespace isostack::cli
