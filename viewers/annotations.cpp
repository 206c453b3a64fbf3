#include "viewers/annotations.h"

#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>

namespace isostack {

namespace {

// Shares of the picture's height.
constexpr double title_size = 0.032;
constexpr double label_size = 0.024;
constexpr double margin = 0.035;

/// A text whose size is set in pixels; VTK's font sizes are in points of 1/72 inch at the window's resolution.
void style_text(vtkTextActor& text, const Eigen::Vector3d& colour) {
  vtkTextProperty& look = *text.GetTextProperty();
  look.SetFontFamilyToArial();
  look.SetColor(colour.x(), colour.y(), colour.z());
  look.SetJustificationToCentered();
  text.SetTextScaleModeToNone();
}

/// Keeps title and bar in proportion to the picture and to the camera's scale each time it is drawn.
class ScaleBar : public vtkCommand {
 public:
  static ScaleBar* New() { return new ScaleBar; }

  void attach(const Eigen::Vector3d& colour, vtkRenderer& renderer) {
    vtkNew<vtkCellArray> line;
    line->InsertNextCell({0, 1, 2, 3, 4, 5});
    points_->SetNumberOfPoints(6);
    shape_->SetPoints(points_);
    shape_->SetLines(line);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape_);
    bar_->SetMapper(mapper);
    bar_->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
    style_text(*label_, colour);
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
    bar_->GetProperty()->SetLineWidth(static_cast<float>(0.0025 * height));
    label_->SetInput(fmt::format("{:g} mm", length_mm).c_str());
    label_->GetTextProperty()->SetFontSize(static_cast<int>(label_size * height));
    label_->SetDisplayPosition(static_cast<int>((left + right) / 2), static_cast<int>(bottom + 1.5 * tick));
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkPolyData> shape_;
  vtkNew<vtkActor2D> bar_;
  vtkNew<vtkTextActor> label_;
};

class Title : public vtkCommand {
 public:
  static Title* New() { return new Title; }

  void attach(const std::string& title, const Eigen::Vector3d& colour, vtkRenderer& renderer) {
    text_->SetInput(title.c_str());
    style_text(*text_, colour);
    text_->GetTextProperty()->SetVerticalJustificationToTop();
    renderer.AddActor2D(text_);
    renderer.AddObserver(vtkCommand::StartEvent, this);
  }

  void Execute(vtkObject* caller, unsigned long, void*) override {
    const int* size = static_cast<vtkRenderer*>(caller)->GetSize();
    text_->GetTextProperty()->SetFontSize(static_cast<int>(title_size * size[1]));
    text_->SetDisplayPosition(size[0] / 2, static_cast<int>((1 - margin) * size[1]));
  }

 private:
  vtkNew<vtkTextActor> text_;
};

}  // namespace

double round_length_mm(double longest_mm) {
  const double power = std::pow(10, std::floor(std::log10(longest_mm)));
  for (const double step : {5.0, 2.0})
    if (step * power <= longest_mm) return step * power;
  return power;
}

void add_title(const std::string& title, const Eigen::Vector3d& colour, vtkRenderer& renderer) {
  if (title.empty()) return;
  vtkNew<Title> command;
  command->attach(title, colour, renderer);
}

void add_scale_bar(const Eigen::Vector3d& colour, vtkRenderer& renderer) {
  vtkNew<ScaleBar> command;
  command->attach(colour, renderer);
}

}  // namespace isostack
