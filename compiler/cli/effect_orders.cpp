// A pair commutes when three pictures in one order equal the three in the other. The first has the values of the scene; the
// other two change every number that feeds the two effects, each by a factor of its own between a half and one and a half, so
// that nothing cancels out by chance (two colours that are both white, a strength of 0). Pictures are small and have 8 bits a
// channel: what differs by less than that, or out of sight, is not seen, and a pair of which the picture shows nothing is
// said to be so.

#include "cli/effect_orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "cli/commands.h"
#include "runtime/render.h"

namespace plugc {
namespace {

constexpr std::uint32_t kSide = 64;
constexpr int kRounding = 2;  ///< Steps of 255 by which equal pictures of different programs may differ.
constexpr int kValueSets = 3;

/// How far two pictures are apart.
struct Difference {
  int most = 0;  ///< Of 255.
  std::size_t pixels = 0;
};

Difference compare(const Picture& a, const Picture& b) {
  Difference difference;
  for (std::size_t pixel = 0; pixel + 3 < std::min(a.pixels.size(), b.pixels.size()); pixel += 4) {
    int most = 0;
    for (std::size_t i = pixel; i < pixel + 3; ++i) most = std::max(most, std::abs(a.pixels[i] - b.pixels[i]));
    if (most <= kRounding) continue;
    difference.most = std::max(difference.most, most);
    ++difference.pixels;
  }
  return difference;
}

/// Between a half and one and a half; the same in every run.
double factor(std::uint32_t slot, std::size_t component, int set) {
  std::uint32_t hash =
      slot * 2654435761U + static_cast<std::uint32_t>(component) * 40503U + static_cast<std::uint32_t>(set) * 97U;
  hash ^= hash >> 13U;
  hash *= 1274126177U;
  return 0.5 + static_cast<double>(hash >> 16U) / 65536.0;
}

std::vector<double> changed_values(const PackedScene& scene, std::uint32_t slot, int set) {
  const PackedSlot& packed = *scene.slots()->Get(slot);
  std::vector<double> values;
  for (std::uint32_t i = 0; i < packed.count() * component_count(packed.type()); ++i) {
    const double own = scene.slot_values()->Get(packed.first() + i);
    const bool is_whole = packed.type() == PackedValueType::bool_ || packed.type() == PackedValueType::int_;
    // what is 0 would stay 0 whatever the factor
    values.push_back(set == 0 || is_whole ? own : own == 0 ? factor(slot, i, set) - 0.5 : own * factor(slot, i, set));
  }
  return values;
}

/// Draws a scene in one arrangement of a pair.
class PairDrawer {
 public:
  PairDrawer(const std::string& scene, CompileOptions options, Validator& validator, Renderer& renderer)
      : scene_(scene), options_(std::move(options)), validator_(validator), renderer_(renderer) {}

  using Pictures = std::array<Picture, kValueSets>;
  Pictures draw(const SceneEffectPair& pair, PairOrder order);
  const std::string& error() const { return error_; }

 private:
  const std::string& scene_;
  CompileOptions options_;
  Validator& validator_;
  Renderer& renderer_;
  std::string error_;
};

PairDrawer::Pictures PairDrawer::draw(const SceneEffectPair& pair, PairOrder order) {
  SourceSet sources;
  Diagnostics unheard(sources);
  options_.arrangement = EffectArrangement{pair.first, pair.second, order};
  const std::vector<std::uint8_t> bytes = write_package(compile({scene_}, options_, validator_, sources, unheard).package);
  const PackageView view = open_package(bytes);
  Pictures pictures;
  if (view.package == nullptr || !renderer_.load(*view.package, 0, error_)) return pictures;
  FrameOptions frame;
  frame.width = frame.height = kSide;
  for (int set = 0; set < kValueSets; ++set) {
    for (const std::uint32_t slot : pair.slots)
      renderer_.set_slot(slot, changed_values(*view.package->scenes()->Get(0), slot, set));
    pictures[static_cast<std::size_t>(set)] = renderer_.draw(frame);
  }
  return pictures;
}

constexpr std::string_view kSetNames[kValueSets] = {"the scene's field values", "other field values", "yet other field values"};

/// The largest difference, with the set of values that shows it.
std::string verdict(const PairDrawer::Pictures& written, const PairDrawer::Pictures& exchanged) {
  Difference worst;
  std::size_t worst_set = 0;
  for (std::size_t set = 0; set < kValueSets; ++set) {
    const Difference difference = compare(written[set], exchanged[set]);
    if (difference.most <= worst.most) continue;
    worst = difference;
    worst_set = set;
  }
  if (worst.pixels == 0) return "";
  return fmt::format("differ by up to {} of 255 at {} of {} pixels, with {}", worst.most, worst.pixels, kSide * kSide,
                     kSetNames[worst_set]);
}

bool is_seen(const PairDrawer::Pictures& with, const PairDrawer::Pictures& without) {
  for (std::size_t set = 0; set < kValueSets; ++set) {
    if (compare(with[set], without[set]).pixels != 0) return true;
  }
  return false;
}

std::string judge_pair(PairDrawer& drawer, const SceneEffectPair& pair) {
  const PairDrawer::Pictures written = drawer.draw(pair, PairOrder::as_written);
  std::string said = verdict(written, drawer.draw(pair, PairOrder::exchanged));
  if (!said.empty()) return said;
  return is_seen(written, drawer.draw(pair, PairOrder::neither)) ? "commute" : "cannot be told: the picture shows neither";
}

}  // namespace

int print_effect_orders(const std::string& scene, const CompileOptions& options, Validator& validator) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const std::vector<SceneEffectPair> pairs = effect_pairs(scene, options, sources, diagnostics);
  const int status = report(diagnostics);
  fmt::print("{} pairs of effects meet at a plug\n", pairs.size());
  if (pairs.empty()) return status;
  RendererOptions renderer_options;
  renderer_options.single_picture = true;
  std::string error;
  const std::unique_ptr<Renderer> renderer = Renderer::make(renderer_options, error);
  if (renderer != nullptr) {
    PairDrawer drawer(scene, options, validator, *renderer);
    for (const SceneEffectPair& pair : pairs) {
      fmt::print("`{}`, `{}` at {}: {}\n", pair.first_label, pair.second_label, fmt::join(pair.plugs, ", "),
                 judge_pair(drawer, pair));
    }
    error = drawer.error();
  }
  if (error.empty()) return status;
  fmt::print(stderr, "plugc: {}: {}\n", scene, error);
  return kBrokenUse;
}

}  // namespace plugc
