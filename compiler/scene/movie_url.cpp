#include "scene/movie_url.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include <fmt/format.h>

namespace plugc {
namespace {

constexpr std::string_view kCounter = "@counter(";
constexpr int kMostDigits = 9;

}  // namespace

bool names_picture(std::string_view url) {
  if (url.starts_with("data:image/")) return true;
  static constexpr std::array<std::string_view, 7> kPictures = {".png", ".jpg", ".jpeg", ".gif", ".bmp", ".tga", ".dds"};
  std::string lower(url.substr(0, url.find('#')));
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::any_of(kPictures, [&](std::string_view ending) { return lower.ends_with(ending); });
}

bool has_picture_url(const NodeGraph& graph, NodeId movie_texture) {
  const auto urls = graph.field(movie_texture, "url").strings;
  return std::ranges::any_of(urls, [](const MappedText& url) { return names_picture(url.text()); });
}

std::string numbered_picture(std::string_view url, int number) {
  const std::size_t begin = url.find(kCounter);
  const std::size_t end = begin == std::string_view::npos ? begin : url.find(')', begin);
  if (end == std::string_view::npos) return std::string(url);
  const std::string_view digits = url.substr(begin + kCounter.size(), end - begin - kCounter.size());
  int width = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), width);
  if (read.ec != std::errc() || read.ptr != digits.data() + digits.size() || width < 1 || width > kMostDigits)
    return std::string(url);
  return fmt::format("{}{:0{}}{}", url.substr(0, begin), number, width, url.substr(end + 1));
}

}  // namespace plugc
