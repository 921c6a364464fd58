#pragma once
// Urls that carry their data themselves (RFC 2397), and base64 (RFC 4648), in which they mostly do.

#include <optional>
#include <string>
#include <string_view>

namespace plugc {

/// Whether a url, white space before it aside, starts with `data:`.
bool is_data_url(std::string_view url);

/// The bytes behind the comma, base64 or percent-encoded; nullopt when there is no comma or the base64 is broken.
std::optional<std::string> data_url_bytes(std::string_view url);

/// White space and padding are passed over; nullopt where any other character is no digit of base64.
std::optional<std::string> base64_decode(std::string_view text);

std::string base64_encode(std::string_view bytes);

}  // namespace plugc
