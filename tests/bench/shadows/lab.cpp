// shadow_lab OUTPUT_FOLDER [--quick] [--only EXPERIMENT] [--methods A,B] [--cache FOLDER] SCENE...
// Exit status 2 where nothing can be measured. tests/bench/shadows/run calls it and draws the charts.

#include <cstdio>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "shadows/experiments.h"

namespace plugc {
namespace {

struct Arguments {
  std::filesystem::path output;
  std::vector<std::filesystem::path> scenes;
  std::vector<std::string> methods = {"bilinear"};
  std::set<std::string> only;
  std::string cache;
  bool quick = false;
};

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words;
  std::stringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = [&] { return ++i < words.size() ? words[i] : std::string(); };
    if (words[i] == "--quick") {
      arguments.quick = true;
    } else if (words[i] == "--only") {
      for (const std::string& name : split(value())) arguments.only.insert(name);
    } else if (words[i] == "--methods") {
      arguments.methods = split(value());
    } else if (words[i] == "--cache") {
      arguments.cache = value();
    } else if (arguments.output.empty()) {
      arguments.output = words[i];
    } else {
      arguments.scenes.emplace_back(words[i]);
    }
  }
  return arguments;
}

int measure(const Arguments& arguments) {
  Validator validator({});  // before the renderer starts threads
  std::string error;
  const std::unique_ptr<Studio> studio = Studio::make(arguments.cache, error);
  if (studio == nullptr) {
    fmt::print(stderr, "shadow_lab: nothing can be drawn: {}\n", error);
    return 2;
  }
  std::filesystem::create_directories(arguments.output);
  Lab lab{validator, *studio, arguments.scenes, arguments.methods, arguments.output, arguments.quick};
  const auto run = [&](const char* name, void (*experiment)(Lab&)) {
    if (!arguments.only.empty() && !arguments.only.contains(name)) return;
    fmt::print(stderr, "shadow_lab: {}\n", name);
    experiment(lab);
  };
  run("lookups", measure_lookups);
  run("times", measure_all_times);
  run("errors", measure_all_errors);
  run("bias", sweep_bias);
  run("stability", sweep_stability);
  run("budget", evaluate_budgets);
  for (const std::string& message : studio->take_messages()) fmt::print(stderr, "shadow_lab: {}\n", message);
  return 0;
}

}  // namespace

std::vector<std::uint32_t> map_sizes(const Lab& lab, const std::string& method) {
  if (method == "traced") return {0};
  if (lab.quick) return {512, 2048};
  std::vector<std::uint32_t> sizes = {128, 256, 512, 1024, 2048, 4096, 8192};
  if (method.ends_with("sm")) sizes.pop_back();  // moments: more than 32 bytes a texel, of which maps have at most 4096 a side
  return sizes;
}

Settings sized(std::uint32_t size) {
  Settings settings;
  if (size != 0) settings.size = size;
  return settings;
}

std::string csv_line(const std::vector<std::string>& words, const std::vector<double>& numbers) {
  std::string line;
  for (const std::string& word : words) line += word + ",";
  for (const double number : numbers) line += fmt::format("{:.6g},", number);
  line.back() = '\n';
  return line;
}

std::vector<FrameOptions> judged_frames(const Package& package, bool quick) {
  constexpr std::uint32_t kWidth = 640, kHeight = 360;  // the share of wrong pixels does not depend on it
  std::vector<FrameOptions> frames;
  const std::uint32_t count = package.scenes()->Get(0)->viewpoints()->size();
  for (std::uint32_t i = 0; i < (quick ? 1 : std::max(count, 1U)); ++i) {
    FrameOptions frame;
    frame.width = kWidth;
    frame.height = kHeight;
    if (count > 0) frame.viewpoint = std::to_string(i);
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace plugc

int main(int count, char** words) {
  const plugc::Arguments arguments = plugc::read_arguments({words + 1, words + count});
  if (arguments.output.empty() || arguments.scenes.empty()) {
    fmt::print(stderr,
               "usage: shadow_lab OUTPUT_FOLDER [--quick] [--only EXPERIMENT] [--methods A,B] [--cache FOLDER] SCENE...\n");
    return 2;
  }
  return plugc::measure(arguments);
}
