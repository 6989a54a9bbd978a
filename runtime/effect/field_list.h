// Field lists: what an effect may be told, each field with name, unit, range, default and one sentence, once.
//
// A list is a tuple of fields in the order of the reference. From it come the parameters of the function that declares the effect, with
// their errors, annotations and reference; what is taken over into the description; and layout and limits on the wire.
// A field that the description does not keep as it was given (a name that stands for something, a place that hangs on another) has no
// place: it is a parameter alone, and who declares the effect sees to it.
//
// Thread: any; constant.
#pragma once

#include "haptics/math/spatial.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace fulcrum::runtime {

/// What a parameter may be in Lua.
enum class ParameterType : std::uint8_t {
    number,   ///< within [low, high]
    integer,  ///< a whole number within [low, high]
    flag,     ///< true or false
    text,     ///< UTF-8, at most `high` bytes
    name,     ///< a-z, 0-9, _ and -
    vector,   ///< {x, y, z}, {x=, y=, z=} or anything with x, y, z; each within [low, high]
    function,
    texts,     ///< a list of texts
    lists,     ///< a table: name -> list of texts
    rules,     ///< a table: name -> text
    values,    ///< a table: name -> number or boolean
    choice,    ///< one of `choices`
    record,    ///< a table of `fields`
    material,  ///< what world:material gave, or the name of a material
    boxes,     ///< a list of { at = {x, y, z}, size = {x, y, z} }
};

/// A default that says "this must be given".
inline constexpr const char* kRequired = nullptr;

struct Parameter {
    const char* name = "";
    ParameterType type = ParameterType::number;
    const char* unit = "";  ///< "kilograms"; empty for a pure number or none
    double low = 0.0;
    double high = 0.0;
    const char* fallback =
        kRequired;  ///< as Lua text, e.g. "0.05", "{0, 0, 0}"; "nil": as the description has it
    const char* text = "";
    const char* choices = "";           ///< of a choice: its names, a blank between two
    const Parameter* fields = nullptr;  ///< of a record: `n_fields` of them
    std::size_t n_fields = 0;
};

/// Of a field that is a parameter alone.
struct NoPlace {};

/// A field and where the description keeps it: a pointer to a member, or what gives a reference to it, `[](auto& kite) -> auto& { … }`. A
/// number, a whole number, a flag, a vector, a text or name, or an enum whose values are numbered as its choices stand.
template <class Place>
struct Field {
    Parameter row;
    Place place;
    double kept_per_unit = 1.0;  ///< what is kept for one of the unit that is told

    static constexpr bool kIsKept = !std::is_same_v<Place, NoPlace>;
    /// Where it is kept in that owner.
    template <class Owner>
    [[nodiscard]] constexpr auto& in(Owner& owner) const {
        if constexpr (std::is_member_object_pointer_v<Place>) {
            return owner.*place;
        } else {
            return place(owner);
        }
    }
    /// Its range as it is kept.
    [[nodiscard]] constexpr double least() const {
        return std::min(kept_per_unit * row.low, kept_per_unit * row.high);
    }
    [[nodiscard]] constexpr double most() const {
        return std::max(kept_per_unit * row.low, kept_per_unit * row.high);
    }
};

/// Lessons turn things in degrees: radians of one, and how many a radian has.
inline constexpr double kPerDegree = std::numbers::pi / 180.0;
inline constexpr double kDegrees = 180.0 / std::numbers::pi;

template <class Place>
[[nodiscard]] constexpr Field<Place> field(Place place, Parameter row, double kept_per_unit = 1.0) {
    return {row, place, kept_per_unit};
}
/// A parameter alone.
[[nodiscard]] constexpr Field<NoPlace> argument(Parameter row) {
    return {row, {}, 1.0};
}

/// The list's parameters.
template <class... Fields>
[[nodiscard]] constexpr std::array<Parameter, sizeof...(Fields)> parameters_of(
    const std::tuple<Fields...>& list) {
    return std::apply(
        [](const auto&... fields) {
            return std::array<Parameter, sizeof...(fields)>{fields.row...};
        },
        list);
}

/// Calls visit(field) for each that is kept.
template <class... Fields, class Visit>
constexpr void for_each_kept(const std::tuple<Fields...>& list, Visit&& visit) {
    const auto look = [&](const auto& field) {
        if constexpr (std::remove_cvref_t<decltype(field)>::kIsKept) {
            visit(field);
        }
    };
    std::apply([&](const auto&... fields) { (look(fields), ...); }, list);
}

/// Calls visit(name) for each of a choice's names.
template <class Visit>
constexpr void for_each_choice(std::string_view choices, Visit&& visit) {
    while (!choices.empty()) {
        const std::size_t end = std::min(choices.find(' '), choices.size());
        if (end > 0) {
            visit(choices.substr(0, end));
        }
        choices.remove_prefix(std::min(end + 1, choices.size()));
    }
}
/// How many names a choice has.
[[nodiscard]] constexpr std::size_t count_choices(std::string_view choices) {
    std::size_t n = 0;
    for_each_choice(choices, [&](std::string_view /*name*/) { ++n; });
    return n;
}
/// The place of a name among the choices; how many there are where it is none.
[[nodiscard]] constexpr std::size_t find_choice(std::string_view choices, std::string_view name) {
    std::size_t found = count_choices(choices);
    std::size_t at = 0;
    for_each_choice(choices, [&](std::string_view each) {
        found = each == name ? std::min(found, at) : found;
        ++at;
    });
    return found;
}

}  // namespace fulcrum::runtime
