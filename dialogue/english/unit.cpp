#include "dialogue/english/unit.h"

#include "dialogue/english/word_table.h"

#include <array>

namespace fulcrum::dialogue {

bool is_unit(std::string_view plural) {
    constexpr std::array<std::string_view, 21> kUnits = {
        "newtons", "metres", "meters",    "kilometres", "kilometers", "centimetres", "seconds",
        "minutes", "hours",  "kilograms", "grams",      "kilos",      "litres",      "liters",
        "joules",  "watts",  "volts",     "degrees",    "pascals",    "hertz",       "millimetres"};
    return contains(kUnits, plural);
}

}  // namespace fulcrum::dialogue
