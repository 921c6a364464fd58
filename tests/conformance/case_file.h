#pragma once
// A .case file: one behaviour of the whole compiler, as a scene and what must come of it.
//
//     # What the case shows, in a sentence or two.
//     --- file scene.x3dv          the first file is compiled; further ones lie beside it
//     --- scene scene.x3d          in place of it, several times: each is compiled, and all that stands below holds for each
//     --- file part.x3dvz gzip     written compressed; likewise a scene
//     --- image wood.png           rows of pixels, top first, as RRGGBBAA; written as a PNG
//     --- options                  a word a line: lint; library; optimize; stage teapot; target essl300, dynamic DEF.field
//                                  (once or several times)
//     --- diagnostics              everything that is said, in order: `LINE:COLUMN code message`; absent: nothing
//     --- diagnostics scene.x3d    the same of one scene of several
//     --- graph                    lines that `--dump scene` begins with hold in this order, without the places
//     --- fragment 0               lines that the fragment stage of program 0 holds in this order, blanks aside;
//                                  likewise `vertex` and `geometry`, the texts of the first target
//     --- fragment 0 lacks         lines that it does not hold
//     --- package                  lines that `--dump package` holds in this order
//     --- programs                 how many programs the package has
//     --- effects                  of a library: `NAME needs PLUGS; offers PLUGS; KIND; KIND ...`, in order
//     --- pixels                   `X Y: R G B` in a picture of 32 by 32 pixels, from the top left; `pixels DEF.field=0 ...`
//                                  with dynamic fields changed; `time=T` of the scene at that time
//     --- values 1.5               `DEF.field: NUMBERS` that slots hold at that time, after the scene has been seen at 0

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

  /// The first section of that title, and with that second word if one is asked for.
  const CaseSection* find(std::string_view title, std::string_view second = "") const;
};

/// Every .case below a folder, in name order.
std::vector<CaseFile> read_case_files(const std::filesystem::path& folder);

/// Writes the file anew with other lines in the `diagnostics` section of `scene` ("" where there is but one scene), which
/// goes away when there are none.
void rewrite_diagnostics(CaseFile& file, std::string_view scene, const std::vector<std::string>& lines);

/// The lines joined again, each with its end.
std::string section_text(const CaseSection& section);

}  // namespace plugc
