#include "viewers/window/scene_window.h"

#include <X11/Xlib.h>
#include <poll.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkMath.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include "io/images/write_pictures.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"
#include "viewers/window/scene_window_parts.h"

namespace isostack {

namespace {

/// After this long without motion all triangles are drawn again.
constexpr double still_seconds = 0.3;
constexpr int idle_milliseconds = 15;

}  // namespace

SceneWindow::SceneWindow(WindowModel& model, const SceneWindowOptions& options) : model_(model), options_(options) {
  window_->SetMultiSamples(0);
  window_->SetDPI(72);  // a point of a font is a pixel, whatever the screen
  window_->SetSize(options.width_pixels, options.height_pixels);
  const std::string& title = model.scene().title;
  window_->SetWindowName(("isostack   " + title.substr(0, title.find('\n'))).c_str());
  const SceneLook look{.dark = model.session().dark, .grey = model.grey(), .quality = Quality::fast};
  scene_.emplace(model, ScenePanel::Which::result, look, *window_);
  if (!model.beside().surfaces.empty()) {
    SceneLook beside_look = look;
    beside_look.marks = false;
    beside_.emplace(model, ScenePanel::Which::beside, beside_look, *window_);
    beside_->renderer().SetActiveCamera(scene_->renderer().GetActiveCamera());
  }
  slice_.emplace(look.dark, *window_);
  status_.emplace(look.dark, *window_);
  help_.emplace(look.dark, *window_);
  interactor_->SetRenderWindow(window_);
  interactor_->EnableRenderOff();  // drawn once a turn, however many events came
  style_->set_input(this);
  interactor_->SetInteractorStyle(style_);
  vtkNew<vtkCallbackCommand> on_event;
  on_event->SetCallback(on_window_event);
  on_event->SetClientData(this);
  for (const unsigned long event : {vtkCommand::ExposeEvent, vtkCommand::ConfigureEvent})
    interactor_->AddObserver(event, on_event);
  lay_out();
  if (model.state().camera)
    scene_->set_camera(*model.state().camera);
  else
    scene_->view().aim(look.view_from);  // anew, now that its part of the window is known
  scene_->set_moving(true);              // makes the proxies now rather than at the first motion
  scene_->set_moving(false);
  interactor_->Initialize();
  loss_.emplace(window_->GetGenericDisplayId(), window_->GetGenericWindowId());
  update();
  scene_->warm_up();
  slice_->warm_up();
  draw();
  update();
  draw();
}

SceneWindow::~SceneWindow() {
  interactor_->SetInteractorStyle(nullptr);
  window_->Finalize();
}

void SceneWindow::on_window_event(vtkObject* /*caller*/, unsigned long event, void* window, void* /*data*/) {
  auto& self = *static_cast<SceneWindow*>(window);
  if (event == vtkCommand::ConfigureEvent) self.lay_out();
  self.draw_scene_ = self.draw_slice_ = self.draw_status_ = true;
}

/// The only renderers above the others are the cubes with the patient's directions.
template <class Change>
void SceneWindow::for_each_cube(Change change) {
  vtkRendererCollection& renderers = *window_->GetRenderers();
  vtkCollectionSimpleIterator next;
  renderers.InitTraversal(next);
  while (vtkRenderer* renderer = renderers.GetNextRenderer(next))
    if (renderer->GetLayer() > 0) change(*renderer);
}

/// The strip below; above it the scene, perhaps a second one, and the slice.
void SceneWindow::lay_out() {
  const double bottom =
      std::min(0.5, static_cast<double>(StatusPanel::height_pixels) / std::max(1, window_->GetSize()[1]));
  const WindowLayout layout = model_.state().layout;
  const bool has_scene = layout != WindowLayout::slice, has_slice = layout != WindowLayout::scene;
  const bool has_beside = beside_ && model_.state().side_by_side && has_scene;
  const double scene_right = has_slice && has_scene ? (has_beside ? 0.7 : 0.58) : has_scene ? 1.0 : 0.0;
  const double split = has_beside ? scene_right / 2 : scene_right;
  scene_->renderer().SetViewport(0, bottom, std::max(split, 1e-3), 1);
  if (beside_) beside_->renderer().SetViewport(split, bottom, std::max(scene_right, split + 1e-3), 1);
  slice_->renderer().SetViewport(std::min(scene_right, 0.999), bottom, 1, 1);
  status_->renderer().SetViewport(0, 0, 1, bottom);
  help_->renderer().SetViewport(0, 0, 1, 1);
  // The cube that turns with the scene keeps to the lower left of its part.
  const double height_share = 0.15 * (1 - bottom);
  const int* size = window_->GetSize();
  const double width_share = std::min(split, height_share * size[1] / std::max(1, size[0]));
  for_each_cube([&](vtkRenderer& cube) {
    cube.SetViewport(0.01 * split, bottom + 0.01, 0.01 * split + width_share, bottom + 0.01 + height_share);
  });
  slice_->fit();
  draw_scene_ = draw_slice_ = draw_status_ = true;
  status_seen_.clear();
}

void SceneWindow::update() {
  if (const auto direction = model_.take_camera_request()) {
    scene_->view().aim(*direction);
    draw_scene_ = true;
  }
  if (const std::uint64_t layout = model_.revision(WindowPart::layout); layout != layout_seen_) {
    layout_seen_ = layout;
    lay_out();
  }
  if (scene_->update(model_)) {
    draw_scene_ = true;
    if (events_ > 0) set_moving(true);  // more are likely to follow, as when slices are scrolled
  }
  if (beside_ && beside_->update(model_)) draw_scene_ = true;
  if (slice_->update(model_)) draw_slice_ = true;
  if (std::string text = model_.status_text(); text != status_seen_ || draw_status_) {
    status_->show(text, model_.morph());
    status_seen_ = std::move(text);
    draw_status_ = true;
  }
}

/// Everything within the depth that is drawn, of both scenes: they share a camera.
void SceneWindow::fit_depth() {
  std::array<double, 6> bounds{};
  scene_->renderer().ComputeVisiblePropBounds(bounds.data());
  if (beside_) {
    std::array<double, 6> more{};
    beside_->renderer().ComputeVisiblePropBounds(more.data());
    for (std::size_t axis = 0; axis < 6; axis += 2)
      if (vtkMath::AreBoundsInitialized(more.data())) {
        bounds[axis] = std::min(bounds[axis], more[axis]);
        bounds[axis + 1] = std::max(bounds[axis + 1], more[axis + 1]);
      }
  }
  if (vtkMath::AreBoundsInitialized(bounds.data())) scene_->renderer().ResetCameraClippingRange(bounds.data());
}

/// While work runs in the background the slice and the text answer first; the scene, which takes longest, follows when
/// no more events come. It does not wait where it is the scene itself that is turned, or alone in the window.
bool SceneWindow::scene_can_wait() const {
  constexpr double until_seconds = 0.25;
  return model_.is_busy() && !held_ && quiet_seconds_ < until_seconds && model_.state().layout == WindowLayout::both;
}

/// Draws the panels that have changed; the others stay as they are on the screen.
void SceneWindow::draw() {
  if ((!draw_scene_ && !draw_slice_ && !draw_status_) || loss_->has_happened()) return;
  const Stopwatch watch;
  const WindowLayout layout = model_.state().layout;
  const bool help = model_.wants_help();
  const bool has_scene = layout != WindowLayout::slice && !help;
  const bool waits = draw_scene_ && scene_can_wait();
  const bool draws_scene = draw_scene_ && has_scene && !waits;
  if (!draws_scene && !draw_slice_ && !draw_status_) return;
  for_each_cube([&](vtkRenderer& cube) { cube.SetDraw(draws_scene); });
  scene_->renderer().SetDraw(draws_scene);
  if (beside_) beside_->renderer().SetDraw(draws_scene && model_.state().side_by_side);
  slice_->renderer().SetDraw(draw_slice_ && layout != WindowLayout::scene && !help && model_.shown_plane());
  status_->renderer().SetDraw(draw_status_ && !help);
  help_->renderer().SetDraw(help);
  if (draws_scene) fit_depth();
  window_->Render();
  scene_->renderer().SetDraw(has_scene);  // what is there takes input
  if (beside_) beside_->renderer().SetDraw(has_scene && model_.state().side_by_side);
  slice_->renderer().SetDraw(layout != WindowLayout::scene && !help);
  draw_scene_ = waits;
  draw_slice_ = draw_status_ = false;
  model_.set_camera(scene_->camera());
  ++report_.frames;
  report_.slowest_frame_ms = std::max(report_.slowest_frame_ms, 1000 * watch.seconds());
}

void SceneWindow::set_moving(bool moving) {
  still_seconds_ = 0;
  if (is_moving_ == moving) return;
  is_moving_ = moving;
  scene_->set_moving(moving);
  if (beside_) beside_->set_moving(moving);
  draw_scene_ = true;
}

/// While work runs in the background fewer triangles are drawn all the time, so that the next event need not wait.
void SceneWindow::settle(double seconds) {
  if (model_.is_busy()) return set_moving(true);
  still_seconds_ += seconds;
  if (is_moving_ && still_seconds_ > still_seconds) set_moving(false);
}

void SceneWindow::save_picture(const std::filesystem::path& path) {
  try {
    const int width = window_->GetSize()[0], height = window_->GetSize()[1];
    vtkNew<vtkUnsignedCharArray> pixels;
    window_->GetPixelData(0, 0, width - 1, height - 1, 0, pixels);
    Picture picture{.width_pixels = width, .height_pixels = height, .rgb = {}};
    const std::size_t row_bytes = std::size_t{3} * static_cast<std::size_t>(width);
    picture.rgb.resize(row_bytes * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)  // VTK's rows come from the bottom
      std::memcpy(picture.rgb.data() + static_cast<std::size_t>(height - 1 - y) * row_bytes,
                  pixels->GetPointer(0) + static_cast<std::size_t>(y) * row_bytes, row_bytes);
    write_png(picture, path);
    model_.say("saved " + path.string());
  } catch (const Error& error) {
    model_.say(error.what());
  }
}

bool SceneWindow::wait_for_event(int milliseconds) const {
  auto* display = static_cast<Display*>(window_->GetGenericDisplayId());
  if (XPending(display) > 0) return true;
  pollfd connection{.fd = ConnectionNumber(display), .events = POLLIN, .revents = 0};
  return poll(&connection, 1, milliseconds) > 0;
}

void SceneWindow::run() {
  Stopwatch clock;
  double asked_seconds = 0;  // when the queue of events was last known to be empty
  double tick_seconds = 0;
  while (!interactor_->GetDone() && !model_.wants_to_close() && !loss_->has_happened() &&
         !(options_.is_interrupted && options_.is_interrupted())) {
    if (const double waits_from = clock.seconds(); wait_for_event(idle_milliseconds))
      // Had it waited at all, the event came at its end.
      asked_seconds = clock.seconds() - waits_from > 1e-3 ? clock.seconds() : asked_seconds;
    events_ = 0;
    const bool is_busy = model_.is_busy();
    interactor_->ProcessEvents();
    const double emptied_seconds = clock.seconds();
    const double passed = emptied_seconds - std::exchange(tick_seconds, emptied_seconds);
    quiet_seconds_ = events_ > 0 ? 0 : quiet_seconds_ + passed;
    model_.tick(passed);
    settle(passed);
    update();
    draw();
    if (const auto path = model_.take_picture_request()) save_picture(*path);
    if (events_ > 0) {
      const double answer_ms = 1000 * (clock.seconds() - asked_seconds);
      report_.events += events_;
      report_.slowest_answer_ms = std::max(report_.slowest_answer_ms, answer_ms);
      if (is_busy) {
        report_.events_while_busy += events_;
        report_.slowest_answer_while_busy_ms = std::max(report_.slowest_answer_while_busy_ms, answer_ms);
      }
    }
    asked_seconds = emptied_seconds;
  }
}

SceneWindowReport open_scene_window(WindowContent content, const SceneWindowOptions& options) {
  const Stopwatch opening;
  WindowModel model(std::move(content));
  auto window = std::make_unique<SceneWindow>(model, options);
  const double opened_ms = 1000 * opening.seconds();
  window->run();
  SceneWindowReport report = window->report();
  report.opened_ms = opened_ms;
  // What the graphics library keeps of a window that was taken away cannot be given back: it asks the server about it.
  if (window->is_lost()) static_cast<void>(window.release());
  window.reset();
  const Stopwatch stopping;
  model.stop();
  report.closing_ms = 1000 * stopping.seconds();
  return report;
}

}  // namespace isostack
