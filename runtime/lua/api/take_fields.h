// Takes what a lesson gave over into the description, by a field list.
#pragma once

#include "runtime/effect/field_list.h"
#include "runtime/lua/api/binding_table.h"

#include <string>
#include <type_traits>
#include <vector>

namespace fulcrum::runtime {

/// The lists' parameters, one after the other.
template <class... Lists>
[[nodiscard]] std::vector<Parameter> rows_of(const Lists&... lists) {
    std::vector<Parameter> rows;
    const auto add = [&rows](const auto& some) {
        rows.insert(rows.end(), some.begin(), some.end());
    };
    (add(parameters_of(lists)), ...);
    return rows;
}

/// Every field that was given or has a default of its own; another one keeps what the owner has.
template <class... Fields, class Owner>
void take_fields(const std::tuple<Fields...>& list, const Arguments& arguments, Owner& owner) {
    for_each_kept(list, [&](const auto& field) {
        const Parameter& row = field.row;
        const Argument& told = arguments[row.name];
        if (!told.given && row.fallback != kRequired && std::string_view(row.fallback) == "nil") {
            return;
        }
        auto& kept = field.in(owner);
        using Kept = std::remove_cvref_t<decltype(kept)>;
        if constexpr (std::is_same_v<Kept, bool>) {
            kept = told.flag;
        } else if constexpr (std::is_same_v<Kept, Vector3>) {
            kept = told.vector;
        } else if constexpr (std::is_same_v<Kept, std::string>) {
            kept = told.text;
        } else if constexpr (std::is_same_v<Kept, std::vector<std::string>>) {
            kept = told.texts;
        } else if constexpr (std::is_same_v<Kept, std::decay_t<decltype(told.lists)>>) {
            kept = told.lists;
        } else if constexpr (std::is_same_v<Kept, std::decay_t<decltype(told.values)>>) {
            kept = told.values;
        } else if constexpr (std::is_enum_v<Kept>) {
            kept = static_cast<Kept>(find_choice(row.choices, told.text));
        } else {
            kept = static_cast<Kept>(field.kept_per_unit * told.number);
        }
    });
}

}  // namespace fulcrum::runtime
