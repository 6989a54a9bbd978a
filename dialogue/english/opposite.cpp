#include "dialogue/english/opposite.h"

#include <array>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// Each pair holds both ways.
constexpr std::array<std::pair<std::string_view, std::string_view>, 32> kOpposites = {{
    {"heavy", "light"},    {"big", "small"},  {"large", "little"},    {"long", "short"},
    {"high", "low"},       {"hot", "cold"},   {"warm", "cool"},       {"fast", "slow"},
    {"hard", "soft"},      {"thick", "thin"}, {"wide", "narrow"},     {"deep", "shallow"},
    {"strong", "weak"},    {"loud", "quiet"}, {"rough", "smooth"},    {"wet", "dry"},
    {"old", "young"},      {"good", "bad"},   {"near", "far"},        {"expensive", "cheap"},
    {"bright", "dark"},    {"full", "empty"}, {"easy", "difficult"},  {"early", "late"},
    {"clean", "dirty"},    {"happy", "sad"},  {"rich", "poor"},       {"sharp", "blunt"},
    {"stiff", "flexible"}, {"bumpy", "flat"}, {"sticky", "slippery"}, {"easy", "hard"},
}};

}  // namespace

std::vector<std::string_view> opposites_of(std::string_view adjective) {
    std::vector<std::string_view> found;
    for (const auto& [one, other] : kOpposites) {
        if (adjective == one || adjective == other) {
            found.push_back(adjective == one ? other : one);
        }
    }
    return found;
}

}  // namespace fulcrum::dialogue
