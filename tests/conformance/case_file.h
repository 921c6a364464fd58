#pragma once
// A .case file: one behaviour of the whole compiler, as a scene and what must come of it.
//
//     # What the case shows, in a sentence or two.
//     --- file scene.x3dv          the first file is compiled; further ones lie beside it
//     --- image wood.png           rows of pixels, top first, as RRGGBBAA; written as a PNG
//     --- options                  a word a line: lint; stage teapot; target essl300
//     --- diagnostics              everything that is said, in order: `LINE:COLUMN code message`; absent: nothing
//     --- fragment 0               lines that the fragment stage of program 0 holds in this order, blanks aside
//     --- fragment 0 lacks         lines that it does not hold
//     --- programs                 how many programs the package has
//     --- pixels                   `X Y: R G B` in a picture of 32 by 32 pixels, from the top left

#include <filesystem>
#include <string>
#include <vector>

namespace plugc {

struct CaseSection {
  std::vector<std::string> title;  ///< Words behind the dashes.
  std::size_t line = 0;            ///< Of the title, from 1.
  std::vector<std::string> lines;
};

struct CaseFile {
  std::filesystem::path path;
  std::string name;               ///< `plugs.order` for plugs/order.case.
  std::vector<std::string> head;  ///< The lines above the first section.
  std::vector<CaseSection> sections;

  const CaseSection* find(std::string_view title) const;
};

/// Every .case below a folder, in name order.
std::vector<CaseFile> read_case_files(const std::filesystem::path& folder);

/// Writes the file anew with other lines in its `diagnostics` section, which goes away when there are none.
void rewrite_diagnostics(CaseFile file, const std::vector<std::string>& lines);

/// The lines joined again, each with its end.
std::string section_text(const CaseSection& section);

}  // namespace plugc
