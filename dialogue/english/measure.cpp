#include "dialogue/english/measure.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {

constexpr std::array kMeasures = {
    Measure{"heavy", "light", "weight", "more", "most", "much", true},
    Measure{"light", "heavy", "weight", "less", "least", "little", true},
    Measure{.adjective = "big", .opposite = "small", .noun = "size"},
    Measure{.adjective = "small", .opposite = "big", .noun = "size"},
    Measure{.adjective = "large", .opposite = "small", .noun = "size"},
    Measure{.adjective = "tall", .opposite = "short", .noun = "height"},
    Measure{.adjective = "high", .opposite = "low", .noun = "height"},
    Measure{.adjective = "low", .opposite = "high", .noun = "height"},
    Measure{.adjective = "long", .opposite = "short", .noun = "length"},
    Measure{.adjective = "short", .opposite = "long", .noun = "length"},
    Measure{.adjective = "fast", .opposite = "slow", .noun = "speed"},
    Measure{.adjective = "slow", .opposite = "fast", .noun = "speed"},
    Measure{.adjective = "strong", .opposite = "weak", .noun = "strength"},
    Measure{.adjective = "weak", .opposite = "strong", .noun = "strength"},
    Measure{.adjective = "old", .opposite = "young", .noun = "age"},
    Measure{.adjective = "young", .opposite = "old", .noun = "age"},
    Measure{.adjective = "hard", .opposite = "soft", .is_felt = true},
    Measure{.adjective = "soft", .opposite = "hard", .is_felt = true},
    Measure{.adjective = "rough", .opposite = "smooth", .is_felt = true},
    Measure{.adjective = "smooth", .opposite = "rough", .is_felt = true},
    Measure{.adjective = "slippery", .opposite = "", .is_felt = true},
    Measure{.adjective = "sticky", .opposite = "", .is_felt = true},
    Measure{.adjective = "warm", .opposite = "cold", .is_felt = true},
    Measure{.adjective = "cold", .opposite = "warm", .is_felt = true},
};

}  // namespace

Measure measure_of(std::string_view adjective) {
    const auto* const found = std::ranges::find(kMeasures, adjective, &Measure::adjective);
    return found == kMeasures.end() ? Measure{} : *found;
}

}  // namespace fulcrum::dialogue
