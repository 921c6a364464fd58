#pragma once
// A method, a size and a bias for each light of a scene, so that the errors of its shadow stay within a budget: compiled, drawn
// and measured here, and compiled again by whoever asked.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compile.h"
#include "runtime/measure/light_judge.h"

namespace plugc {

/// `0.5%` as a share of 1; no value for what is none between 0 and 100 %.
std::optional<double> read_percentage(std::string_view text);

struct ShadowErrorRequest {
  double budget = 0;  ///< Share of wrong pixels that is allowed, the mean over the scene's viewpoints.
  std::uint32_t width = 1280, height = 720;
  bool method_given = false;  ///< By `--shadows`, as is the size of CompileOptions::shadows where it is not 0.
};

/// What was found out of one light.
struct ChosenShadow {
  std::string light;
  ShadowChoice choice;
  ShadowTask task;                  ///< Its `receiver_pixels` are of a picture of the request's size.
  double shadowed_share = 0;        ///< Of the pixels that the map shadows.
  std::vector<ShadowTrial> trials;  ///< In the order in which they were measured.
  std::string why_not_traced;       ///< Empty: the truth is traced.
};

/// Chooses for every light with a shadow that some viewpoint shows. Nothing in a library.
std::vector<ChosenShadow> choose_shadows(const std::filesystem::path& scene, const CompileOptions& options,
                                         const ShadowErrorRequest& request, Validator& validator, Studio& studio);

/// What was chosen and why, some lines a light.
std::string explain(const ChosenShadow& chosen);

}  // namespace plugc
