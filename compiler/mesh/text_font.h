#pragma once
// Glyphs as triangles, from the DejaVu fonts of the system.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace plugc {

/// One glyph; x to the right from the pen, y up from the baseline, in pixels of kFontPixels to an em.
struct Glyph {
  float advance = 0;
  std::vector<glm::vec2> points;
  std::vector<std::uint32_t> triangles;  ///< Counter-clockwise.
};

/// Glyphs are hinted at this size and then scaled, so that lines are as long as in viewers that draw text from bitmaps of it.
inline constexpr int kFontPixels = 20;

class Font {
 public:
  /// The font of a FontStyle's family (SERIF, SANS, TYPEWRITER) and style; a style that is not installed gives the plain one.
  /// nullopt when there is no such font at all.
  static std::optional<Font> open(std::string_view family, std::string_view style);

  /// A character without a glyph gives the font's sign for that.
  const Glyph& glyph(std::uint32_t code_point);
  /// Pixels from the baseline down to the lowest of ordinary letters, and up to the highest.
  float descent() const { return descent_; }
  float ascent() const { return ascent_; }

 private:
  struct Face;
  struct CloseFace {
    void operator()(Face* face) const;
  };
  explicit Font(std::unique_ptr<Face, CloseFace> face);

  std::unique_ptr<Face, CloseFace> face_;
  std::map<std::uint32_t, Glyph> glyphs_;
  float descent_ = 0, ascent_ = 0;
};

}  // namespace plugc
