#pragma once
// Which method and size a light's shadow map gets for an error that is allowed: a search that is told errors and asks for
// what to measure next. It knows nothing of pictures or clocks, so that it chooses the same each time.

#include <cstdint>
#include <optional>
#include <vector>

#include "package/package_file.h"

namespace plugc {

/// How a light's shadow is drawn. `scale` is glPolygonOffset's first factor.
struct ShadowConfiguration {
  PackedShadowMethod method = PackedShadowMethod::hard;
  std::uint32_t size = 0;  ///< Texels along a side.
  double scale = 0;

  bool operator==(const ShadowConfiguration&) const = default;
};

/// A method that may be taken, at any size.
struct ShadowCandidate {
  PackedShadowMethod method = PackedShadowMethod::hard;
  double scale = 0;
  std::uint32_t largest = 0;  ///< Size that such a map can have.
};

struct ShadowTask {
  double budget = 0;           ///< Share of wrong pixels that is allowed: 0.005 for 0.5 %.
  double floor_of_texel = 0;   ///< hard_map_floor() of a map, times its size.
  double receiver_pixels = 0;  ///< That look into the map; the mean of the views.
  int faces = 1;               ///< Of the map: 6 for a cube map.
  std::vector<ShadowCandidate> candidates;
  std::optional<std::uint32_t> size;  ///< Written: no other is tried.
};

struct ShadowTrial {
  ShadowConfiguration configuration;
  double error = 0;  ///< Share of wrong pixels.
  double cost = 0;   ///< shadow_cost().
};

/// Sizes are multiples of it, and at least 128.
inline constexpr std::uint32_t kSizeStep = 64;
inline constexpr std::uint32_t kSmallestSize = 128;

/// Ask next(), measure, record(), until next() has nothing more.
class ShadowSearch {
 public:
  explicit ShadowSearch(ShadowTask task);

  /// What to measure: of everything that may turn out cheaper than the best so far, what looks cheapest.
  std::optional<ShadowConfiguration> next() const;
  void record(const ShadowConfiguration& configuration, double error);
  /// A closer look found another error than record() was told; next() goes on from that.
  void correct(const ShadowConfiguration& configuration, double error);

  /// The cheapest trial within the budget; null while there is none.
  const ShadowTrial* best() const;
  /// The trial with the least error; null before the first.
  const ShadowTrial* nearest() const;
  const std::vector<ShadowTrial>& trials() const { return trials_; }

 private:
  struct Branch {
    ShadowCandidate candidate;
    std::uint32_t size = 0;                  // to be tried next; 0: nothing, or nothing that gives hope
    std::uint32_t fails = 0;                 // the largest size that was not enough
    std::optional<std::uint32_t> satisfies;  // the smallest size that was
  };

  double hoped_cost(const Branch& branch) const;
  const Branch* cheapest_branch() const;
  std::uint32_t size_for(double error_of_texel, const ShadowCandidate& candidate) const;
  std::optional<ShadowConfiguration> last_resort() const;
  Branch* branch_of(const ShadowConfiguration& configuration);
  void go_on(Branch& branch, double error) const;

  ShadowTask task_;
  std::vector<Branch> branches_;
  std::vector<ShadowTrial> trials_;
};

}  // namespace plugc
