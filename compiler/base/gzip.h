#pragma once
// Gzip-compressed files (`.x3dvz`, `.wrz`, `.gz`) read as what they hold, whatever their name says.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace plugc {

bool is_gzip(std::string_view bytes);

/// The uncompressed bytes; nullopt when the data is damaged or holds more than `limit` bytes. Source: RFC 1952.
std::optional<std::string> gunzip(std::string_view bytes, std::size_t limit);

}  // namespace plugc
