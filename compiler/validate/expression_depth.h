#pragma once
// How deep a parsed stage nests. Drivers walk such trees by recursion and end with their stack; this tells before they do.

namespace glslang {
class TIntermediate;
}

namespace plugc {

/// What every driver that plugc has met survives by far; no author's code comes near it.
inline constexpr int kMaxTreeDepth = 2000;

/// Nodes on the longest path from the root; a chain `a + b + c` of n terms is n deep.
int tree_depth(const glslang::TIntermediate& stage);

}  // namespace plugc
