// "Did you mean": the known name nearest to one that is not known.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lightbench {

// The name of fewest edits (Levenshtein 1965: insert, delete, replace), the first of equals; none if more than a third of the longer
// word would have to change, so that nonsense gets no answer.
std::optional<std::string_view> nearest_name(std::string_view word, std::span<const std::string_view> names);

// For the end of a message: `; did you mean "X"?` if something is near, else the list of what there is.
std::string suggestion(std::string_view word, std::span<const std::string_view> names);

} // namespace lightbench
