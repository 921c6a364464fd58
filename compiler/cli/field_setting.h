#pragma once
// A field's value on the command line: `Glow.enabled=FALSE`, `Paint.diffuseColor=1 0.5 0`.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plugc {

struct FieldSetting {
  std::string name;            ///< `DEF.field`
  std::vector<double> values;  ///< Booleans are 0 and 1.
};

/// nullopt where the text is no `DEF.field=VALUE`. Numbers are divided by blanks or commas.
std::optional<FieldSetting> read_field_setting(std::string_view text);

}  // namespace plugc
