#pragma once
// What the laboratory measures. Each experiment writes one table, a CSV file in the output folder.

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/measure/instrument.h"
#include "runtime/measure/studio.h"
#include "validate/validate.h"

namespace plugc {

struct Lab {
  Validator& validator;
  Studio& studio;
  std::vector<std::filesystem::path> scenes;
  std::vector<std::string> methods;  ///< Names of `--shadows`.
  std::filesystem::path output;      ///< A folder.
  bool quick = false;                ///< Fewer sizes, views and repetitions: minutes become seconds.
};

/// Sides of the maps that a method is measured with; 0 alone for the one without a map.
std::vector<std::uint32_t> map_sizes(const Lab& lab, const std::string& method);
/// `size` 0: what the scene says.
Settings sized(std::uint32_t size);

/// errors.csv: every scene, view, method and size.
void measure_all_errors(Lab& lab);
/// times.csv: milliseconds of a frame without shadows, with maps kept, with maps drawn anew.
void measure_all_times(Lab& lab);
/// lookups.csv: nanoseconds that a method takes a pixel, in a picture that is all receiver.
void measure_lookups(Lab& lab);
/// bias.csv: false shadow and false light over a grid of glPolygonOffset's factors.
void sweep_bias(Lab& lab);
/// stability.csv: the light's elevation, far / near, the scene's scale and its distance from the origin.
void sweep_stability(Lab& lab);

/// budget.csv: what --shadow-error chooses in each scene, against the cheapest of everything; everything.csv: that.
void evaluate_budgets(Lab& lab);

/// One line of a table. Numbers have six significant digits.
std::string csv_line(const std::vector<std::string>& words, const std::vector<double>& numbers);

/// The frames that a scene is judged from: its viewpoints, small enough for thousands of pictures.
std::vector<FrameOptions> judged_frames(const Package& package, bool quick);

}  // namespace plugc
