#include "viewers/window/status_panel.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "viewers/window/view_keys.h"

namespace isostack {

namespace {

constexpr int margin = 10;
constexpr int slider_height = 12;  ///< of its middle above the strip's bottom

void style_text(vtkTextActor& text, const Eigen::Vector3d& ink, int height_pixels) {
  vtkTextProperty& look = *text.GetTextProperty();
  look.SetFontSize(height_pixels);
  look.SetColor(ink.x(), ink.y(), ink.z());
  look.SetVerticalJustificationToTop();
  text.SetTextScaleModeToNone();
}

void add_line(int from, int to, double width, const Eigen::Vector3d& colour, Overlay& overlay) {
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(from, slider_height, 0);
  points->InsertNextPoint(to, slider_height, 0);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({0, 1});
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetLines(line);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(polydata);
  const auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  overlay.add(actor);
}

Eigen::Vector3d ink_on(bool dark) { return Eigen::Vector3d::Constant(dark ? 0.92 : 0.15); }
Eigen::Vector3d ground_of(bool dark) { return Eigen::Vector3d::Constant(dark ? 0.16 : 0.86); }

}  // namespace

StatusPanel::StatusPanel(bool dark, vtkRenderWindow& window) : slider_(*renderer_), ink_(ink_on(dark)) {
  renderer_->SetBackground(ground_of(dark).data());
  renderer_->InteractiveOff();
  style_text(*text_, ink_, 15);
  renderer_->AddActor2D(text_);
  window.AddRenderer(renderer_);
}

void StatusPanel::show(const std::string& text, const Playback& morph) {
  const int* size = renderer_->GetSize();
  text_->SetInput(text.c_str());
  text_->SetPosition(margin, size[1] - 6);
  slider_.clear();
  if (morph.count() < 2) return;
  const int right = size[0] - margin;
  const double share = static_cast<double>(morph.position()) / static_cast<double>(morph.count() - 1);
  const int knob = margin + static_cast<int>(std::lround(share * (right - margin)));
  add_line(margin, right, 2, ink_, slider_);
  add_line(std::max(margin, knob - 5), std::min(right, knob + 5), 12, ink_, slider_);
}

std::optional<std::ptrdiff_t> StatusPanel::frame_at(int x, int y, const Playback& morph) const {
  const int* size = renderer_->GetSize();
  if (morph.count() < 2 || !renderer_->IsInViewport(x, y) || y > 2 * slider_height) return std::nullopt;
  const double share = static_cast<double>(x - margin) / std::max(1, size[0] - 2 * margin);
  return std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(morph.count() - 1));
}

HelpPanel::HelpPanel(bool dark, vtkRenderWindow& window) {
  renderer_->SetBackground(ground_of(dark).data());
  renderer_->InteractiveOff();
  renderer_->DrawOff();
  style_text(*text_, ink_on(dark), 15);
  text_->GetTextProperty()->SetFontFamilyToCourier();
  text_->SetInput(key_help().c_str());
  text_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text_->SetPosition(0.03, 0.98);
  renderer_->AddActor2D(text_);
  window.AddRenderer(renderer_);
}

}  // namespace isostack
