// "Did you mean ...?"
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumb::cli {

/// The entry of `known` with the fewest insertions, deletions, substitutions and swaps of
/// neighbours away from `word`; the first of equals. Empty if even that is more than a third of
/// `word` (of a word of one or two letters: more than one) away.
std::string nearest(std::string_view word, std::span<const std::string> known);

}  // namespace plumb::cli
