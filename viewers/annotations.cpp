#include "viewers/annotations.h"

#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace isostack {

namespace {

// Shares of the picture's height.
constexpr double title_size = 0.032;
constexpr double label_size = 0.024;
constexpr double margin = 0.035;

/// A text whose size is set in pixels; VTK's font sizes are in points of 1/72 inch at the window's resolution.
void style_text(vtkTextActor& text, const TextColours& colours) {
  vtkTextProperty& look = *text.GetTextProperty();
  look.SetFontFamilyToArial();
  look.SetColor(colours.ink.x(), colours.ink.y(), colours.ink.z());
  look.SetBackgroundColor(colours.ground.x(), colours.ground.y(), colours.ground.z());
  look.SetBackgroundOpacity(0.8);  // to be read on images too
  look.SetJustificationToCentered();
  look.SetLineSpacing(1.25);
  text.SetTextScaleModeToNone();
  text.GetPositionCoordinate()->SetCoordinateSystemToViewport();
}

/// Keeps title and bar in proportion to the picture and to the camera's scale each time it is drawn.
class ScaleBar : public vtkCommand {
 public:
  static ScaleBar* New() { return new ScaleBar; }

  void attach(const TextColours& colours, vtkRenderer& renderer) {
    vtkNew<vtkCellArray> line;
    line->InsertNextCell({0, 1, 2, 3, 4, 5});
    points_->SetNumberOfPoints(6);
    shape_->SetPoints(points_);
    shape_->SetLines(line);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape_);
    halo_->SetMapper(mapper);
    halo_->GetProperty()->SetColor(colours.ground.x(), colours.ground.y(), colours.ground.z());
    bar_->SetMapper(mapper);
    bar_->GetProperty()->SetColor(colours.ink.x(), colours.ink.y(), colours.ink.z());
    style_text(*label_, colours);
    renderer.AddActor2D(halo_);
    renderer.AddActor2D(bar_);
    renderer.AddActor2D(label_);
    renderer.AddObserver(vtkCommand::StartEvent, this);
  }

  void Execute(vtkObject* caller, unsigned long, void*) override {
    vtkRenderer& renderer = *static_cast<vtkRenderer*>(caller);
    const double width = renderer.GetSize()[0], height = renderer.GetSize()[1];
    const double mm_per_pixel = 2 * renderer.GetActiveCamera()->GetParallelScale() / height;
    const double length_mm = round_length_mm(0.2 * width * mm_per_pixel);
    const double right = width - margin * height, left = right - length_mm / mm_per_pixel;
    const double bottom = margin * height, tick = 0.008 * height;
    const double corners[6][2] = {{left, bottom + tick}, {left, bottom - tick},  {left, bottom},
                                  {right, bottom},       {right, bottom + tick}, {right, bottom - tick}};
    for (int i = 0; i < 6; ++i) points_->SetPoint(i, corners[i][0], corners[i][1], 0);
    points_->Modified();
    halo_->GetProperty()->SetLineWidth(static_cast<float>(0.0075 * height));
    bar_->GetProperty()->SetLineWidth(static_cast<float>(0.0025 * height));
    label_->SetInput(fmt::format("{:g} mm", length_mm).c_str());
    label_->GetTextProperty()->SetFontSize(static_cast<int>(label_size * height));
    label_->SetPosition((left + right) / 2, bottom + 1.5 * tick);
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkPolyData> shape_;
  vtkNew<vtkActor2D> halo_, bar_;  ///< the halo is for images under the bar
  vtkNew<vtkTextActor> label_;
};

/// Keeps a title within the picture each time it is drawn.
class PlaceTitle : public vtkCommand {
 public:
  static PlaceTitle* New() { return new PlaceTitle; }
  vtkSmartPointer<vtkTextActor> text;

  void Execute(vtkObject* caller, unsigned long, void*) override {
    auto& renderer = *static_cast<vtkRenderer*>(caller);
    const int* size = renderer.GetSize();
    vtkTextProperty& look = *text->GetTextProperty();
    look.SetFontSize(std::max(1, static_cast<int>(title_size * size[1])));
    double text_pixels[2] = {0, 0};
    text->GetSize(&renderer, text_pixels);
    const double most = (1 - 2 * margin) * size[0];
    if (text_pixels[0] > most)
      look.SetFontSize(std::max(6, static_cast<int>(look.GetFontSize() * most / text_pixels[0])));
    text->SetPosition(size[0] / 2.0, (1 - margin) * size[1]);
  }
};

}  // namespace

double round_length_mm(double longest_mm) {
  const double power = std::pow(10, std::floor(std::log10(longest_mm)));
  for (const double step : {5.0, 2.0})
    if (step * power <= longest_mm) return step * power;
  return power;
}

Title::Title(const TextColours& colours, vtkRenderer& renderer) : text_(vtkSmartPointer<vtkTextActor>::New()) {
  style_text(*text_, colours);
  text_->GetTextProperty()->SetVerticalJustificationToTop();
  renderer.AddActor2D(text_);
  vtkNew<PlaceTitle> place;
  place->text = text_;
  renderer.AddObserver(vtkCommand::StartEvent, place);
}

void Title::set(const std::string& title) {
  text_->SetInput(title.c_str());
  text_->SetVisibility(!title.empty());
}

void add_scale_bar(const TextColours& colours, vtkRenderer& renderer) {
  vtkNew<ScaleBar> command;
  command->attach(colours, renderer);
}

}  // namespace isostack
