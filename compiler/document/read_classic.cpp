// Recursive descent over the tokens of ClassicScanner, bounded by kMaxNesting.
// Source: ISO/IEC 19776-2 (grammar in A.3), ISO/IEC 14772-1, annex A.
//
// Each mistake is reported once, where it stands. Then the nearest reading is taken (a missing `{` is assumed, a list
// without `]` ends before what cannot belong to it) or tokens are skipped up to the next field or closing bracket.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "document/classic_reader.h"
#include "document/read_document.h"

namespace plugc {
namespace {

/// Whether `text` begins with `lower`, in letters of either case.
bool begins_with(std::string_view text, std::string_view lower) {
  const auto equal = [](char small, char any) {
    return small == any || (any >= 'A' && any <= 'Z' && small == any - 'A' + 'a');
  };
  return text.size() >= lower.size() && std::equal(lower.begin(), lower.end(), text.begin(), equal);
}

/// The words of the first line: `#X3D V3.2 utf8`.
std::vector<std::string_view> header_words(std::string_view text) {
  std::vector<std::string_view> words;
  std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  while (words.size() < 3) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos) break;
    line.remove_prefix(begin);
    words.push_back(line.substr(0, line.find_first_of(" \t")));
    line.remove_prefix(words.back().size());
  }
  return words;
}

/// `V3.2`, also where it hangs on the first word; "" when there is none.
std::string_view version_word(const std::vector<std::string_view>& words, std::size_t name_size) {
  const std::string_view glued = words[0].substr(std::min(name_size, words[0].size()));
  return glued.empty() && words.size() > 1 ? words[1] : glued;
}

/// The first word that a header spells otherwise than the standard, or the last one when there are too few.
std::optional<std::string_view> odd_word(const std::vector<std::string_view>& words, std::string_view name) {
  if (words[0] != name) return words[0];
  if (words.size() > 1 && !words[1].starts_with('V')) return words[1];
  if (words.size() < 3) return words.back();
  return words[2] == "utf8" ? std::nullopt : std::optional(words[2]);
}

}  // namespace

bool is_classic_header(std::string_view text) {
  return begins_with(text, "#x3d") || begins_with(text, "#vrml");
}

bool is_vrml1_header(std::string_view text) {
  return begins_with(text, "#vrml v1");
}

Document ClassicReader::read(std::string_view version, const Span& version_span) {
  if (!version.empty()) set_version(build_, version, version_span);
  const std::string_view text = build_.sources.text(build_.document.source);
  constexpr std::size_t kFieldsOfNode = 2;  // more than usual
  const auto braces = static_cast<std::size_t>(std::count(text.begin(), text.end(), '{'));
  build_.expect(braces, kFieldsOfNode * braces, 0);
  const std::size_t mark = build_.statements.open();
  read_statements(false);
  build_.document.statements = build_.statements.close(mark, build_.document.statement_pool);
  return std::move(build_.document);
}

// Mistakes

/// Says nothing where the same token was unexpected before: that is one mistake.
void ClassicReader::expected(std::string_view what) {
  if (unexpected_at_ == scan_.offset()) return;
  unexpected_at_ = scan_.offset();
  end_was_reported_ |= scan_.at_end();
  build_.mistake(scan_.next_span(), fmt::format("expected {}, found {}", what, scan_.describe_next()));
}

Name ClassicReader::expect_name(std::string_view what) {
  if (!scan_.next_is(kWordStart)) {
    expected(what);
    return {};
  }
  return scan_.take_word();
}

/// A name that the author chooses: none of the words of the grammar.
Name ClassicReader::expect_own_name(std::string_view what) {
  static constexpr std::array<std::string_view, 20> kKeywords = {
      "AS", "DEF",  "EXPORT", "EXTERNPROTO", "FALSE",    "IMPORT",       "IS",    "NULL",      "PROTO",      "ROUTE",
      "TO", "TRUE", "USE",    "eventIn",     "eventOut", "exposedField", "field", "inputOnly", "outputOnly", "inputOutput"};
  const Name name = expect_name(what);
  if (std::find(kKeywords.begin(), kKeywords.end(), name.text) != kKeywords.end()) {
    build_.mistake(name.span, fmt::format("`{}` is a word of the language; choose another name", name.text));
  }
  return name;
}

/// `TO` between the ends of a ROUTE; where it was forgotten a name goes on.
bool ClassicReader::expect_to() {
  if (scan_.peek_word() == "TO") {
    scan_.take_word();
    return true;
  }
  expected("`TO`");
  return scan_.next_is(kWordStart);
}

bool ClassicReader::expect_dot() {
  if (scan_.take('.')) return true;
  expected("`.`");
  return false;
}

/// At the end of the text every open bracket lacks its other half; that is one mistake, told for the innermost.
void ClassicReader::not_closed(const Span& span, std::string_view what) {
  if (stopped() || end_was_reported_ || (scan_.at_end() && stray_bracket_was_reported_)) return;
  end_was_reported_ = scan_.at_end();
  build_.mistake(span, fmt::format("{} is not closed before {}", what, scan_.describe_next()));
}

Document read_classic(SourceId source, const SourceSet& sources, Diagnostics& diagnostics) {
  const std::string_view text = sources.text(source);
  const std::size_t bom = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const auto words = header_words(text.substr(bom));
  const bool vrml = !words.empty() && begins_with(words[0], "#vrml");
  ClassicReader reader(source, vrml ? Encoding::vrml2 : Encoding::classic, sources, diagnostics);
  if (words.empty()) return reader.read("", {});
  const auto span_of = [&](std::string_view word) {
    const auto begin = static_cast<std::uint32_t>(word.data() - text.data());
    return Span{source, begin, begin + static_cast<std::uint32_t>(word.size())};
  };
  const std::string_view name = vrml ? "#VRML" : "#X3D";
  const std::string_view word = version_word(words, name.size());
  const std::string_view version = word.substr(begins_with(word, "v") ? 1 : 0);
  if (const auto odd = odd_word(words, name)) {
    diagnostics.report(DiagnosticId::header_odd, span_of(*odd),
                       fmt::format("this header is not quite `{} V{} utf8`, but is read as that", name,
                                   !version.empty() ? shown(version)
                                   : vrml           ? "2.0"
                                                    : "3.0"));
  }
  return reader.read(version, span_of(word));
}

}  // namespace plugc
