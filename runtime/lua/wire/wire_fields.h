// Layout and limits of what a field list says of its owner.
#pragma once

#include "runtime/effect/field_list.h"
#include "runtime/lua/wire/wire_archive.h"

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace fulcrum::runtime::wire {

using TextPairs = std::vector<std::pair<std::string, std::string>>;
using TextLists = std::vector<std::pair<std::string, std::vector<std::string>>>;

template <class Archive, class Texts>
void texts(Archive& a, const char* what, Texts& values) {
    a.list(what, values, kMaxListItems,
           [what](auto& each, auto& value) { each.text(what, value, kMaxTextBytes); });
}

template <class Archive, class Pairs>
void pairs(Archive& a, const char* what, Pairs& values) {
    a.list(what, values, kMaxListItems, [what](auto& each, auto& value) {
        each.text(what, value.first, kMaxNameBytes);
        each.text(what, value.second, kMaxTextBytes);
    });
}

template <class Archive, class Lists>
void lists(Archive& a, const char* what, Lists& values) {
    a.list(what, values, kMaxListItems, [](auto& each, auto& value) {
        each.name("a list's name", value.first);
        texts(each, "a list", value.second);
    });
}

/// All that the list keeps, within its range or as it is where nothing was said of it.
template <class Archive, class... Fields, class Owner>
void fields(Archive& a, const std::string& whose, const std::tuple<Fields...>& list, Owner& owner) {
    const std::remove_cvref_t<Owner> unsaid{};
    for_each_kept(list, [&](const auto& field) {
        const std::string label = whose + "'s " + field.row.name;
        const char* what = label.c_str();
        auto& value = field.in(owner);
        using Kept = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<Kept, bool>) {
            a.flag(what, value);
        } else if constexpr (std::is_same_v<Kept, Vector3>) {
            vector(a, what, value, field.most());
        } else if constexpr (std::is_same_v<Kept, std::string>) {
            if (field.row.type == ParameterType::name) {
                a.name(what, value);
            } else {
                a.text(what, value, static_cast<std::size_t>(field.most()));
            }
        } else if constexpr (std::is_same_v<Kept, std::vector<std::string>>) {
            texts(a, what, value);
        } else if constexpr (std::is_same_v<Kept, TextPairs>) {
            pairs(a, what, value);
        } else if constexpr (std::is_same_v<Kept, TextLists>) {
            lists(a, what, value);
        } else if constexpr (std::is_enum_v<Kept>) {
            a.choice(what, value, static_cast<Kept>(count_choices(field.row.choices) - 1));
        } else if constexpr (std::is_integral_v<Kept>) {
            a.integer(
                what, value,
                std::min(static_cast<std::int64_t>(field.least()), std::int64_t{field.in(unsaid)}),
                static_cast<std::int64_t>(field.most()));
        } else {
            a.number(what, value, field.least(), field.most(), field.in(unsaid));
        }
    });
}

}  // namespace fulcrum::runtime::wire
