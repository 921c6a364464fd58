#pragma once
// What the url of a MovieTexture names: a file that holds a movie, or pictures that are one.

#include <string>
#include <string_view>

#include "scene/node_graph.h"

namespace plugc {

/// False for a file that only a movie decoder reads, by its ending; such files are not read.
bool names_picture(std::string_view url);
/// Whether one of the texture's urls does.
bool has_picture_url(const NodeGraph& graph, NodeId movie_texture);

/// A series of pictures, as the reference engine writes it: `fire@counter(4).png` is fire0000.png, fire0001.png, ... The name
/// of one of them; a url without `@counter` stays as it is.
std::string numbered_picture(std::string_view url, int number);

}  // namespace plugc
