#include "segmentation/start_steps.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

using Numbers = std::vector<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::optional<Numbers> numbers_in(std::string_view text) {
  Numbers numbers;
  while (!text.empty()) {
    const std::string_view item = text.substr(0, text.find(','));
    double value = 0;
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
    if (error != std::errc() || end != item.data() + item.size() || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
    if (item.size() == text.size()) return numbers;
    text.remove_prefix(item.size() + 1);
    if (text.empty()) return std::nullopt;
  }
  return numbers;
}

bool all_positive(const Numbers& numbers, std::size_t from = 0) {
  for (std::size_t i = from; i < numbers.size(); ++i)
    if (!(numbers[i] > 0)) return false;
  return true;
}

/// What a word means: how many numbers it takes and how they become a step (nothing: out of bounds).
struct Word {
  std::string_view name;
  std::size_t fewest, most;
  std::string_view needs;  ///< completes "needs ..."
  std::optional<StartStep> (*make)(const Numbers&);
};

using Made = std::optional<StartStep>;

template <class Step>
Made plain(const Numbers&) {
  return Step{};
}

Made make_otsu(bool brighter_inside, const Numbers& n) {
  if (n.empty()) return OtsuStep{brighter_inside};
  return n[0] > 0 && n[0] < 1 ? Made(OtsuStep{brighter_inside, n[0]}) : Made();
}

const std::array<Word, 16>& words() {
  static const std::array<Word, 16> table = {{
      {"gaussian", 1, 1, "a standard deviation in pixels above 0, as in gaussian:1",
       [](const Numbers& n) -> Made { return all_positive(n) ? Made(GaussianStep{n[0]}) : Made(); }},
      {"diffusion", 1, 2, "a grey step above 0 and perhaps a number of steps, as in diffusion:30,10",
       [](const Numbers& n) -> Made {
         if (!all_positive(n)) return {};
         DiffusionOptions options{.contrast = n[0]};
         if (n.size() > 1) options.steps = static_cast<int>(std::min(n[1], 1000.0));
         return DiffusionStep{options};
       }},
      {"level", 1, 1, "a grey value, as in level:150",
       [](const Numbers& n) -> Made {
         return RangeStep{{n[0], infinity}};
       }},
      {"darker", 1, 1, "a grey value, as in darker:-300",
       [](const Numbers& n) -> Made {
         return RangeStep{{-infinity, n[0]}};
       }},
      {"range", 2, 2, "two grey values, the lower first, as in range:-20,80",
       [](const Numbers& n) -> Made {
         return n[0] < n[1] ? Made(RangeStep{{n[0], n[1]}}) : Made();
       }},
      {"otsu", 0, 1, "nothing, or a share between 0 and 1, as in otsu:0.5",
       [](const Numbers& n) -> Made { return make_otsu(true, n); }},
      {"otsu-darker", 0, 1, "nothing, or a share between 0 and 1, as in otsu-darker:0.5",
       [](const Numbers& n) -> Made { return make_otsu(false, n); }},
      {"like-seeds", 0, 1, "a number of standard deviations above 0, as in like-seeds:2.5",
       [](const Numbers& n) -> Made {
         if (!all_positive(n)) return {};
         return n.empty() ? SeedRangeStep{} : SeedRangeStep{n[0]};
       }},
      {"connected", 0, 0, "no number", plain<ConnectedStep>},
      {"grow", 1, 1, "a distance in mm above 0, as in grow:2",
       [](const Numbers& n) -> Made { return all_positive(n) ? Made(GrowStep{n[0]}) : Made(); }},
      {"shrink", 1, 1, "a distance in mm above 0, as in shrink:2",
       [](const Numbers& n) -> Made { return all_positive(n) ? Made(GrowStep{-n[0]}) : Made(); }},
      {"open", 1, 1, "a radius in mm above 0, as in open:3",
       [](const Numbers& n) -> Made { return all_positive(n) ? Made(OpenStep{n[0]}) : Made(); }},
      {"close", 1, 1, "a radius in mm above 0, as in close:3",
       [](const Numbers& n) -> Made { return all_positive(n) ? Made(CloseStep{n[0]}) : Made(); }},
      {"fill-holes", 0, 0, "no number", plain<FillHolesStep>},
      {"hull", 0, 0, "no number", plain<HullStep>},
      {"largest", 0, 0, "no number", plain<LargestStep>},
  }};
  return table;
}

Made make_solid(SolidStep::Operation operation, std::string_view shape, const Numbers& n) {
  const std::size_t count = shape == "sphere" ? 4 : 6;
  if (n.size() != count || !all_positive(n, 3)) return {};
  SolidStep step{operation, {}};
  step.solid.centre_mm = {n[0], n[1], n[2]};
  step.solid.half_size_mm = shape == "sphere" ? Eigen::Vector3d::Constant(n[3]) : Eigen::Vector3d(n[3], n[4], n[5]);
  if (shape == "box") {
    step.solid.shape = Solid::Shape::box;
    step.solid.half_size_mm /= 2;
  }
  return step;
}

[[noreturn]] void refuse(const std::string& text, std::string_view needs) {
  throw InputError("start step '" + text + "'", "it cannot be understood", "it needs " + std::string(needs));
}

std::optional<StartStep> parse_solid(const std::string& text, std::string_view word, const Numbers& numbers) {
  using Operation = SolidStep::Operation;
  constexpr std::array<std::pair<std::string_view, Operation>, 3> operations = {
      {{"add-", Operation::add}, {"keep-", Operation::keep}, {"remove-", Operation::remove}}};
  for (const auto& [prefix, operation] : operations) {
    if (!word.starts_with(prefix)) continue;
    const std::string_view shape = word.substr(prefix.size());
    if (shape != "sphere" && shape != "box" && shape != "ellipsoid") return std::nullopt;
    Made made = make_solid(operation, shape, numbers);
    if (!made)
      refuse(text, shape == "sphere" ? "a centre and a radius in mm: X,Y,Z,R"
                   : shape == "box"  ? "a centre and three edges in mm: X,Y,Z,DX,DY,DZ"
                                     : "a centre and three half axes in mm: X,Y,Z,RX,RY,RZ");
    return made;
  }
  return std::nullopt;
}

}  // namespace

bool is_filter(const StartStep& step) {
  return std::holds_alternative<GaussianStep>(step) || std::holds_alternative<DiffusionStep>(step);
}

bool is_rule(const StartStep& step) {
  return std::holds_alternative<RangeStep>(step) || std::holds_alternative<OtsuStep>(step) ||
         std::holds_alternative<SeedRangeStep>(step) || std::holds_alternative<LabelStep>(step);
}

StartStep parse_start_step(const std::string& text) {
  const std::string_view word = std::string_view(text).substr(0, text.find(':'));
  const std::optional<Numbers> numbers =
      word.size() == text.size() ? Numbers{} : numbers_in(std::string_view(text).substr(word.size() + 1));
  for (const Word& known : words()) {
    if (known.name != word) continue;
    const bool counts = numbers && numbers->size() >= known.fewest && numbers->size() <= known.most;
    const Made made = counts ? known.make(*numbers) : Made();
    if (!made) refuse(text, known.needs);
    return *made;
  }
  if (numbers)
    if (const Made made = parse_solid(text, word, *numbers)) return *made;
  std::string listed;
  for (const Word& known : words())
    if (!known.name.empty()) listed += std::string(listed.empty() ? "" : ", ") + std::string(known.name);
  refuse(text, "one of " + listed + ", or add-, keep-, remove- with sphere, box, ellipsoid");
}

}  // namespace isostack
