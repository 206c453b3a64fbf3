#include "viewers/colour_bar.h"

#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "viewers/line_plot.h"

namespace isostack {

namespace {

// In picture heights.
constexpr double bar_height = 0.52, bar_width = 0.030, bar_step = 0.20, right_margin = 0.155;
constexpr double text_size = 0.024;
constexpr int bands = 128;

vtkSmartPointer<vtkTextActor> text_actor(const std::string& words, const Eigen::Vector3d& ink) {
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->SetInput(words.c_str());
  text->SetTextScaleModeToNone();
  text->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  vtkTextProperty& look = *text->GetTextProperty();
  look.SetFontFamilyToArial();
  look.SetColor(ink.x(), ink.y(), ink.z());
  look.SetVerticalJustificationToCentered();
  return text;
}

/// One bar: coloured bands, a tick's text at its height for each round number.
class Bar {
 public:
  Bar(const VertexValues& values, const Eigen::Vector3d& ink, vtkRenderer& renderer)
      : label(values.label), range(values.range) {
    vtkNew<vtkCellArray> quads;
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    for (int i = 0; i < bands; ++i) {
      quads->InsertNextCell({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
      const Color c = colour_of(range.low + (range.high - range.low) * (i + 0.5) / bands, range);
      colours->InsertNextTuple3(c.red, c.green, c.blue);
    }
    points_->SetNumberOfPoints(2 * (bands + 1));
    shape_->SetPoints(points_);
    shape_->SetPolys(quads);
    shape_->GetCellData()->SetScalars(colours);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape_);
    actor_->SetMapper(mapper);
    for (const double tick : round_ticks(range.low, range.high, 7)) {
      if (tick < range.low - 1e-9 * (range.high - range.low) || tick > range.high + 1e-9 * (range.high - range.low))
        continue;
      ticks_.push_back({tick, text_actor(fmt::format("{:g}", std::abs(tick) < 1e-12 ? 0.0 : tick), ink)});
    }
    title_ = text_actor(label, ink);
    title_->GetTextProperty()->SetVerticalJustificationToBottom();
    title_->GetTextProperty()->SetJustificationToRight();
    renderer.AddActor2D(actor_);
    renderer.AddActor2D(title_);
    for (const auto& [value, text] : ticks_) renderer.AddActor2D(text);
  }

  void remove_from(vtkRenderer& renderer) const {
    renderer.RemoveActor2D(actor_);
    renderer.RemoveActor2D(title_);
    for (const auto& [value, text] : ticks_) renderer.RemoveActor2D(text);
  }

  /// `place`: 0 is the bar farthest to the right.
  void lay_out(int place, double width, double height) {
    const double left = width - (right_margin + place * bar_step) * height, right = left + bar_width * height;
    const double bottom = (1 - bar_height) / 2 * height;
    for (int i = 0; i <= bands; ++i) {
      const double y = bottom + bar_height * height * i / bands;
      points_->SetPoint(2 * i, left, y, 0);
      points_->SetPoint(2 * i + 1, right, y, 0);
    }
    points_->Modified();
    const int size = static_cast<int>(text_size * height);
    for (const auto& [value, text] : ticks_) {
      const double share = (value - range.low) / (range.high - range.low);
      text->GetTextProperty()->SetFontSize(size);
      text->SetPosition(right + 0.010 * height, bottom + bar_height * height * share);
    }
    title_->GetTextProperty()->SetFontSize(size);
    title_->SetPosition(width - 0.02 * height - place * bar_step * height,
                        bottom + (bar_height + 0.025 + 0.035 * place) * height);
  }

  std::string label;
  ColourRange range;

 private:
  struct Tick {
    double value;
    vtkSmartPointer<vtkTextActor> text;
  };
  vtkNew<vtkPoints> points_;
  vtkNew<vtkPolyData> shape_;
  vtkNew<vtkActor2D> actor_;
  vtkSmartPointer<vtkTextActor> title_;
  std::vector<Tick> ticks_;
};

class LayOut : public vtkCommand {
 public:
  static LayOut* New() { return new LayOut; }
  void Execute(vtkObject* caller, unsigned long, void*) override {
    const int* size = static_cast<vtkRenderer*>(caller)->GetSize();
    int place = 0;
    for (const std::unique_ptr<Bar>& bar : bars) bar->lay_out(place++, size[0], size[1]);
  }
  std::vector<std::unique_ptr<Bar>> bars;
};

}  // namespace

struct ColourBars::Parts {
  Eigen::Vector3d ink;
  vtkSmartPointer<vtkRenderer> renderer;
  vtkNew<LayOut> layout;
};

ColourBars::ColourBars(const Eigen::Vector3d& ink, vtkRenderer& renderer) : parts_(std::make_unique<Parts>()) {
  parts_->ink = ink;
  parts_->renderer = &renderer;
  renderer.AddObserver(vtkCommand::StartEvent, parts_->layout);
}

ColourBars::~ColourBars() = default;

void ColourBars::update(const std::vector<SceneSurface>& surfaces) {
  std::vector<std::unique_ptr<Bar>>& bars = parts_->layout->bars;
  for (const std::unique_ptr<Bar>& bar : bars) bar->remove_from(*parts_->renderer);
  bars.clear();
  for (const SceneSurface& surface : surfaces) {
    if (!surface.visible || !surface.values) continue;
    const VertexValues& values = *surface.values;
    bool is_new = true;
    for (const std::unique_ptr<Bar>& bar : bars)
      is_new = is_new && !(bar->label == values.label && bar->range == values.range);
    if (is_new) bars.push_back(std::make_unique<Bar>(values, parts_->ink, *parts_->renderer));
  }
}

double ColourBars::width_in_heights() const {
  const auto count = static_cast<double>(parts_->layout->bars.size());
  return count == 0 ? 0 : right_margin + 0.01 + (count - 1) * bar_step;
}

}  // namespace isostack
