// The longest answer that a lesson offers to choose from: the lessons' test holds them to its length, the panels' test finds room for it.
#pragma once

namespace fulcrum::test {

inline constexpr const char* kLongestChoice = "The wooden block is heavier than the metal block.";

}  // namespace fulcrum::test
