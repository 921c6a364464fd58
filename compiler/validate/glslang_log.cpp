// A log is lines. `ERROR: 0:LINE: 'TOKEN' : WHAT` is a compiler's error; `ERROR: Linking ... stage: WHAT` is the linker's,
// and indented lines below it say what it is about:
//
//     ERROR: Linking vertex and fragment stages: Types must match:
//         vertex stage: " vec3 n"
//         fragment stage: " vec2 n"             ->   fragment stage, token `n`
//     ERROR: Linking fragment stage: No function definition (body) found:
//         f(f1;                                 ->   fragment stage, token `f`
//
// So each message is one line and its indented lines, joined; then its parts are cut off from the front.

#include "validate/glslang_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace plugc {
namespace {

constexpr std::size_t kMaxMessages = 100;
constexpr std::size_t kMaxMessageBytes = 1000;

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// With each run of white space as one space, and none at the ends.
std::string squeezed(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (!is_space(c)) {
      result += c;
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  if (result.ends_with(' ')) result.pop_back();
  return result;
}

/// `12:34:` -> 34. The number before it names a string; there is only one.
bool take_place(std::string_view& text, std::uint32_t& line) {
  const char* end = text.data() + text.size();
  std::uint32_t string = 0;
  const auto first = std::from_chars(text.data(), end, string);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ':') return false;
  const auto second = std::from_chars(first.ptr + 1, end, line);
  if (second.ec != std::errc{} || second.ptr == end || *second.ptr != ':') return false;
  text.remove_prefix(static_cast<std::size_t>(second.ptr + 1 - text.data()));
  return true;
}

/// `'foo' : undeclared identifier` -> `foo`, and what follows the colon.
std::string take_token(std::string_view& text) {
  constexpr std::string_view kEnd = "' : ";
  std::string_view rest = text;
  const std::size_t end = rest.find(kEnd);
  if (!take_prefix(rest, "'") || end == std::string_view::npos) return {};
  text.remove_prefix(end + kEnd.size());
  return std::string(rest.substr(0, end - 1));
}

/// The stage that a linker's message names last: the one that reads what another writes.
ShaderStage last_named_stage(std::string_view text, ShaderStage otherwise) {
  const std::string_view place = text.substr(0, text.find(':'));
  std::size_t last = 0;
  for (const ShaderStage stage : {ShaderStage::vertex, ShaderStage::geometry, ShaderStage::fragment}) {
    const std::size_t found = place.rfind(to_text(stage));
    if (found != std::string_view::npos && found >= last) {
      last = found;
      otherwise = stage;
    }
  }
  return otherwise;
}

/// The name in a linker's detail: the last word in quotes, or the first word where there are none.
std::string name_in_detail(std::string_view detail) {
  const std::size_t quote = detail.rfind('"');
  if (quote == std::string_view::npos) {
    const auto start = std::ranges::find_if(detail, is_word);
    return {start, std::find_if_not(start, detail.end(), is_word)};
  }
  const std::string_view quoted = detail.substr(0, quote);
  const std::size_t before = quoted.find_last_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
  return std::string(quoted.substr(before == std::string_view::npos ? 0 : before + 1));
}

/// Uniforms are compared with those of all stages before, taken together; glslang calls that "unknown stage".
std::string with_earlier_stages(std::string text) {
  constexpr std::string_view kUnknown = "unknown stage", kEarlier = "earlier";
  for (std::size_t at = text.find(kUnknown); at != std::string::npos; at = text.find(kUnknown, at))
    text.replace(at, kUnknown.size(), kEarlier);
  return text;
}

VerdictMessage read_linker_error(std::string_view text, ShaderStage stage) {
  VerdictMessage message;
  message.stage = last_named_stage(text, stage);
  const std::size_t last_line = text.rfind('\n');
  if (last_line != std::string_view::npos) message.token = name_in_detail(text.substr(last_line));
  take_prefix(text, "Linking ");
  message.text = with_earlier_stages(squeezed(text));
  return message;
}

VerdictMessage read_error(std::string_view text, ShaderStage stage) {
  VerdictMessage message;
  message.stage = stage;
  if (!take_place(text, message.line)) return read_linker_error(text, stage);
  while (take_prefix(text, " ")) {
  }
  message.token = take_token(text);
  const std::string what = squeezed(text);
  message.text = message.token.empty() ? what : fmt::format("`{}`: {}", message.token, what);
  return message;
}

/// Where the message at the start of `log` ends: before the next line that is neither indented nor empty.
std::size_t message_end(std::string_view log) {
  std::size_t end = log.find('\n');
  while (end != std::string_view::npos && end + 1 < log.size() && is_space(log[end + 1])) end = log.find('\n', end + 1);
  return end == std::string_view::npos ? log.size() : end + 1;
}

/// `2 compilation errors.  No code generated.`
bool is_summary(std::string_view text) {
  return text.find("compilation errors.") != std::string_view::npos;
}

bool same(const VerdictMessage& a, const VerdictMessage& b) {
  return a.stage == b.stage && a.line == b.line && a.token == b.token && a.text == b.text;
}

void add(std::vector<VerdictMessage>& messages, VerdictMessage message) {
  if (message.text.size() > kMaxMessageBytes) message.text.replace(kMaxMessageBytes, std::string::npos, " ...");
  const bool known = std::ranges::any_of(messages, [&](const VerdictMessage& other) { return same(other, message); });
  if (!known) messages.push_back(std::move(message));
}

}  // namespace

std::vector<VerdictMessage> read_glslang_log(std::string_view log, ShaderStage stage) {
  std::vector<VerdictMessage> messages;
  while (!log.empty()) {
    const std::size_t end = message_end(log);
    std::string_view text = log.substr(0, end);
    log.remove_prefix(end);
    while (text.ends_with('\n') || text.ends_with(' ')) text.remove_suffix(1);
    const bool is_error =
        take_prefix(text, "ERROR: ") || take_prefix(text, "INTERNAL ERROR: ") || take_prefix(text, "UNIMPLEMENTED: ");
    if (!is_error || is_summary(text)) continue;
    if (messages.size() == kMaxMessages) {
      messages.push_back({stage, 0, {}, fmt::format("there are more than {} errors; the rest is left out", kMaxMessages)});
      break;
    }
    add(messages, read_error(text, stage));
  }
  return messages;
}

}  // namespace plugc
