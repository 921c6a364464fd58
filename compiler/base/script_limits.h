#pragma once
// What Scripts may be when they are compiled, and what they may do when they run.

#include <cstddef>
#include <cstdint>

namespace plugc {

inline constexpr std::size_t kMaxScriptTokens = 100'000;          ///< Words of one; each makes a few steps at most.
inline constexpr std::size_t kMaxSceneScriptSize = 8'000'000;     ///< Bytes of code and first values of all in a scene.
inline constexpr std::size_t kMaxScriptFields = 1'024;            ///< Of one that runs.
inline constexpr std::size_t kMaxScriptNumbers = 1'000'000;       ///< That the variables of one hold together.
inline constexpr std::size_t kMaxScriptStack = 100'000;           ///< Values; only what loops gets there.
inline constexpr std::uint64_t kMaxScriptWork = 5'000'000;        ///< Numbers moved by one function: a fraction of a second.
inline constexpr std::uint64_t kMaxFrameScriptWork = 50'000'000;  ///< By all of a scene between two frames.

}  // namespace plugc
