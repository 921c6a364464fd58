// Much of everything, cut short where that hurts, with work that grows with the input and memory that is bounded by it.

#include <fmt/format.h>

#include "attack.h"
#include "base/limits.h"

namespace plugc {
namespace {

constexpr std::size_t kMany = 10'000'000;

/// Reads `text`, which ends too early, in a child: its messages must be what `expected` begins with.
void expect_cut_short(const std::string& text, const std::string& expected, std::size_t times_its_size) {
  const std::size_t peak = peak_of([&] {
    SourceSet sources;
    Diagnostics diagnostics(sources);
    MemoryFiles files;
    const SourceId source = sources.add("s", text);
    build_graph(read_document(source, sources, diagnostics), "s", sources, files, diagnostics);
    if (diagnostics.all().empty()) _exit(1);
    const std::string said = to_text(diagnostics.all()[0], sources);
    if (!said.starts_with(expected)) {
      std::fprintf(stderr, "%.200s\n", said.c_str());
      _exit(1);
    }
  });
  expect_peak(peak, times_its_size * text.size());
}

TEST(Attacks, ManyNumbersMayEndTooEarly) {
  expect_cut_short(classic_scene("Shape { geometry PointSet { coord Coordinate { point [ " + repeated("1.5 ", kMany)),
                   "s:2:54: error: `[` is not closed before the end of the file", 6);
  expect_cut_short(std::string(xml_scene("<Shape><PointSet><Coordinate point='")).substr(0, 63) + repeated("1.5 ", kMany),
                   "s:2:36: error: this `'` begins a value that is not closed", 6);
  expect_cut_short(R"({"X3D":{"Scene":{"-children":[{"Coordinate":{"@point":[)" + repeated("1.5,", kMany),
                   "s:1:55: error: this `[` is not closed before the end of the file", 6);
}

TEST(Attacks, ALongStringIsOneString) {
  const std::string text = classic_scene("WorldInfo { title \"" + std::string(100'000'000, 'a') + "\" }");
  const std::size_t peak = peak_of([&] {
    const auto built = build(text);
    if (built->graph.string(built->root(), "title").size() != 100'000'000) _exit(1);
  });
  expect_peak(peak, 2 * text.size());
}

TEST(Attacks, ALongNameIsCutAndSaidSo) {
  const std::string name(5'000'000, 'N');
  for (const std::string& text : {classic_scene("DEF " + name + " " + name + " { " + name + " 1 }"),
                                  xml_scene("<" + name + " DEF='" + name + "' " + name + "='1'/>"),
                                  json_scene("{\"" + name + "\":{\"@DEF\":\"" + name + "\",\"@" + name + "\":1}}"),
                                  classic_scene("PROTO " + name + " [ field SFInt32 " + name + " 1 ] { } " + name + " { }"),
                                  classic_scene("ROUTE " + name + "." + name + " TO " + name + "." + name)}) {
    const auto built = build(text);
    EXPECT_NE(built->said().find("a name is longer than 1024 bytes; only its beginning counts [syntax]"), std::string::npos);
    for (const Diagnostic& one : built->diagnostics.all()) EXPECT_LE(one.message.size(), kMaxMessageBytes + 3);
    EXPECT_LE(built->said().size(), 20'000U);
  }
}

TEST(Attacks, ALongNumberIsOneMistake) {
  const auto built = build(classic_scene("Box { size " + std::string(1'000'000, '1') + " 0." + std::string(1'000'000, '1') +
                                         " 1e" + std::string(1'000'000, '9') + " }"));
  EXPECT_EQ(built->diagnostics.all().size(), 2U) << built->said();  // too large twice; the many decimals are a number
  EXPECT_EQ(build(xml_scene("<Box size='" + std::string(1'000'000, '1') + " 1 1'/>"))->diagnostics.all().size(), 1U);
}

TEST(Attacks, ManyRoutesAndFieldsAndPrototypesAreWorkOfTheirNumber) {
  constexpr std::size_t kSize = 10'000;
  const auto unroll = [](std::string_view piece) { return [piece](std::size_t n) { return repeated(piece, n); }; };
  const std::string sensors = "DEF T TimeSensor { }\nDEF U TimeSensor { }\n";
  EXPECT_LT(growth([&](std::size_t n) { return classic_scene(sensors + unroll("ROUTE T.isActive TO U.enabled\n")(n)); }, kSize),
            kLinear);
  EXPECT_LT(growth(
                [&](std::size_t n) {
                  return classic_scene(sensors + "DEF S Script { " +
                                       each(n, [](const std::string& i) { return "eventIn SFBool f" + i + "\n"; }) + "}\n" +
                                       each(n, [](const std::string& i) { return "ROUTE T.isActive TO S.f" + i + "\n"; }));
                },
                kSize),
            kLinear);
  EXPECT_LT(
      growth(
          [&](std::size_t n) {
            return classic_scene("PROTO P [ " + each(n, [](const std::string& i) { return "field SFInt32 f" + i + " 1\n"; }) +
                                 "] { Script { " +
                                 each(n, [](const std::string& i) { return "field SFInt32 g" + i + " IS f" + i + "\n"; }) +
                                 "} } P { " + each(n, [](const std::string& i) { return "f" + i + " 2\n"; }) + "}");
          },
          kSize),
      kLinear);
  EXPECT_LT(
      growth([&](std::size_t n) { return classic_scene(unroll("PROTO P [ ] { Group { } }\n")(n) + unroll("P { }\n")(n)); },
             kSize),
      kLinear);
}

TEST(Attacks, MistakesAreWorkOfTheirNumber) {
  constexpr std::size_t kSize = 10'000;
  const auto defs = [](std::size_t n) { return each(n, [](const std::string& i) { return "DEF N" + i + " Group { } "; }); };
  const auto scene = [&](const char* before, const char* behind) {
    return [=](std::size_t n) {
      return classic_scene(defs(n) + each(n, [&](const std::string& i) { return before + i + behind; }));
    };
  };
  EXPECT_LT(growth(scene("USE M", " "), kSize), kLinear);
  EXPECT_LT(growth(scene("Unknown", " { } "), kSize), kLinear);
  EXPECT_LT(growth(scene("ROUTE A", ".a TO B.b "), kSize), kLinear);
  EXPECT_LT(growth(scene("PROTO P", " [ ] { Unknown { } } "), kSize), kLinear);
  EXPECT_LT(growth(scene("Group { g", " 1 } "), kSize), kLinear);
}

TEST(Attacks, BrokenMarkupIsWorkOfItsNumber) {
  constexpr std::size_t kSize = 12'500;  // eight times that: 100,000
  const auto scene = [](std::string_view head, std::string_view first, std::string_view second) {
    return [=](std::size_t n) {
      return "<X3D version='3.3'><Scene>" + std::string(head) + repeated(first, n) + repeated(second, n) + "</Scene></X3D>";
    };
  };
  EXPECT_LT(growth(scene("", "<Group>", "</Transform>"), kSize), kLinear);
  EXPECT_LT(growth(scene("", "<Group><Transform>", "</Group></Transform>"), kSize), kLinear);
  EXPECT_LT(growth(scene("", "<Group><Transform></Group></Transform>", ""), kSize), kLinear);
  EXPECT_LT(growth(scene("", "<Group/>", "</Group>"), kSize), kLinear);
  EXPECT_LT(growth(scene("<Box ", "a=b ", "a "), kSize), kLinear);
  EXPECT_LT(growth(scene("<Box a=b ", "b ", "<"), kSize), kLinear);
  EXPECT_LT(growth(scene("<Box ", "a='", "b"), kSize), kLinear);
  for (const std::string_view opening :
       {"<!-- ", "<![CDATA[ ", "<? ", "<!DOCTYPE [ ", "<Script><![CDATA[<![CDATA[]]></Script>"}) {
    EXPECT_LT(growth(scene("", opening, ""), kSize), kLinear) << opening;
  }
}

TEST(Attacks, BrokenMarkupIsReadToTheLimitOfMistakes) {
  const std::string opens = "<X3D version='3.3'><Scene>" + repeated("<Group>", 100'000);
  for (const std::string& text : {opens + repeated("</Transform>", 100'000), opens + repeated("</Group><Box>", 100'000),
                                  opens + repeated("<Box></Group>", 100'000), opens + repeated("</a></Group>", 100'000)}) {
    const std::size_t peak = peak_of([&] {
      const auto built = build(text);
      const std::size_t said = built->diagnostics.all().size();
      if (said > kMaxSyntaxMistakes + 1 || built->graph.size() > kMaxNesting + kMaxSyntaxMistakes) _exit(1);
    });
    expect_peak(peak, 4 * text.size());
  }
}

TEST(Attacks, MistakesAboutOneNodeOfManyFieldsAreWorkOfTheirNumber) {
  constexpr std::size_t kSize = 5'000;
  const auto fields = [](std::size_t n) {
    return each(n, [](const std::string& i) { return "field SFInt32 f" + i + " 1\n"; });
  };
  EXPECT_LT(growth(
                [&](std::size_t n) {
                  return classic_scene("DEF T TimeSensor { } DEF S Script { " + fields(n) + "}\n" +
                                       each(n, [](const std::string& i) { return "ROUTE T.isActive TO S.g" + i + "\n"; }));
                },
                kSize),
            kLinear);
  EXPECT_LT(
      growth(
          [&](std::size_t n) {
            return classic_scene("PROTO P [ " + fields(n) + "] { Script { " +
                                 each(n, [](const std::string& i) { return "field SFInt32 s" + i + " IS g" + i + "\n"; }) +
                                 "} } P { " + each(n, [](const std::string& i) { return "h" + i + " 2\n"; }) + "}");
          },
          kSize),
      kLinear);
}

TEST(Attacks, StopAtAFilesManyItems) {
  const auto built = build(classic_scene("Script { url [ " + repeated("\"\" ", kMaxDocumentItems + 10) + "] }"));
  EXPECT_NE(built->said().find("this file holds more than 8000000 nodes, fields and strings"), std::string::npos);
  EXPECT_EQ(built->diagnostics.all().size(), 1U) << built->said();
}

/// Whether reading `text` in a child says only that there are too many numbers.
bool says_too_many_numbers(const std::string& text, std::string_view who) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  MemoryFiles files;
  const SourceId source = sources.add("s", text);
  build_graph(read_document(source, sources, diagnostics), "s", sources, files, diagnostics);
  return diagnostics.all().size() == 1 && diagnostics.all()[0].id == DiagnosticId::scene_limit &&
         diagnostics.all()[0].message.find(fmt::format("{} more than {} numbers", who, kMaxDocumentNumbers)) !=
             std::string::npos;
}

TEST(Attacks, StopAtManyNumbers) {
  constexpr std::size_t kMoreThanHalf = kMaxDocumentNumbers / 2 + 1;
  static_assert(kMoreThanHalf % 3 == 0, "whole points, or there is another mistake");
  const std::string numbers = repeated("1 ", kMoreThanHalf);
  const std::string list = "Coordinate { point [" + numbers + "] }\n";
  const std::string element = "<Coordinate point='" + numbers + "'/>\n";
  const std::pair<std::string, std::string_view> texts[] = {
      {classic_scene("Group { children [ " + list + list + "] }"), "holds"}, {xml_scene(element + element), "hold"}};
  constexpr std::size_t kBytesOfNumber = 2 * sizeof(double);  // a list that grows is there twice
  for (const auto& [text, who] : texts) {
    const std::size_t peak = peak_of([&, who = who] {
      if (!says_too_many_numbers(text, who)) _exit(1);
    });
    expect_peak(peak, 2 * text.size() + kBytesOfNumber * kMaxDocumentNumbers + (std::size_t{64} << 20));
  }
}

/// A million of each, in the time of a moment: what grows faster than its number would take hours.
TEST(Attacks, AMillionOfEachTakesAMoment) {
  constexpr std::size_t kMillion = 1'000'000;
  constexpr double kSecondsOfAMoment = 60;
  const std::string texts[] = {
      classic_scene("Script {\n" + each(kMillion, [](const std::string& i) { return "field SFInt32 f" + i + " 1\n"; }) + "}"),
      classic_scene("PROTO P [\n" + each(kMillion, [](const std::string& i) { return "field SFInt32 f" + i + " 1\n"; }) +
                    "] { Group { } } P { }"),
      classic_scene(each(kMillion, [](const std::string& i) { return "PROTO P" + i + " [ ] { Group { } }\n"; })),
      classic_scene(each(kMillion, [](const std::string& i) { return "EXTERNPROTO P" + i + " [ ] \"p\"\n"; })),
      classic_scene(each(kMillion, [](const std::string& i) { return "DEF N" + i + " Group { }\n"; }))};
  for (const std::string& text : texts) {
    const std::clock_t start = std::clock();
    const auto built = build(text);
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, kSecondsOfAMoment) << text.substr(0, 50);
    EXPECT_LE(built->diagnostics.all().size(), 1U) << built->said().substr(0, 500);  // a limit may be told
  }
}

TEST(Attacks, ListNoMoreMessagesThanAnyoneReads) {
  const auto built = build(classic_scene(repeated("Unknown { }\n", 100'000)));
  EXPECT_EQ(built->diagnostics.all().size(), kMaxDiagnostics + 1);
  EXPECT_EQ(built->diagnostics.all().back().id, DiagnosticId::diagnostics_limit);
}

}  // namespace
}  // namespace plugc
