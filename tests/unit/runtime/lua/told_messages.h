// Messages of a lesson in words, by the wire's own layout of them: what a table can hold of a description or a reply.
#pragma once

#include "runtime/effect/tool/plan_tool.h"
#include "runtime/lua/wire/wire_layout.h"
#include "tests/support/table.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <memory>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

namespace fulcrum::runtime::test {

/// Writes fields as "name value", lists as "name {…} {…}", and of what lists hold only what is not as it is made.
class TextWriter {
  public:
    static constexpr bool kReads = false;

    void number(const char* what, const double& value, double /*low*/, double /*high*/,
                double /*or_this*/ = 0.0) {
        char text[32];
        std::snprintf(text, sizeof text, "%.14g", value + 0.0);
        put(what, text);
    }
    template <class Integer>
    void integer(const char* what, const Integer& value, std::int64_t /*low*/,
                 std::int64_t /*high*/) {
        put(what, std::to_string(value));
    }
    void flag(const char* what, const bool& value) { put(what, value ? "yes" : "no"); }
    template <class Enum>
    void choice(const char* what, const Enum& value, Enum /*last*/) {
        if constexpr (requires { name_of(value); }) {
            put(what, std::string(name_of(value)));
        } else if constexpr (requires { to_string(value); }) {
            put(what, std::string(to_string(value)));
        } else {
            put(what, std::to_string(static_cast<int>(value)));
        }
    }
    void text(const char* what, const std::string& value, std::size_t /*most*/) {
        put(what, value.empty() ? "\"\"" : value);
    }
    void name(const char* what, const std::string& value) { text(what, value, 0); }
    template <class List, class Each>
    void list(const char* what, const List& values, std::size_t /*most*/, Each each) {
        std::vector<std::string> told;
        const typename List::value_type made{};
        for (const auto& value : values) {
            TextWriter usual;
            // One of several kinds is told whole.
            if constexpr (!requires { std::variant_size<typename List::value_type>::value; }) {
                each(usual, made);
            }
            TextWriter given;
            each(given, value);
            told.push_back('{' + given.told_beside(usual) + '}');
        }
        put(what, told.empty() ? "none" : spaced(told));
    }
    template <class Variant, class Each>
    void one_of(const char* what, const Variant& value, Each each) {
        std::visit(
            [&](const auto& alternative) {
                put(what, name_of_type(typeid(alternative).name()));
                each(*this, alternative);
            },
            value);
    }
    /// All that is not the same in `usual`.
    [[nodiscard]] std::string told_beside(const TextWriter& usual) const {
        std::vector<std::string> told;
        for (std::size_t i = 0; i < fields_.size(); ++i) {
            const auto same_name = [&](const Field& field) {
                return field.first == fields_[i].first;
            };
            const auto nth = std::count_if(
                fields_.begin(), fields_.begin() + static_cast<std::ptrdiff_t>(i), same_name);
            auto other = std::find_if(usual.fields_.begin(), usual.fields_.end(), same_name);
            for (auto k = nth; k > 0 && other != usual.fields_.end(); --k) {
                other = std::find_if(other + 1, usual.fields_.end(), same_name);
            }
            if (other == usual.fields_.end() || other->second != fields_[i].second) {
                told.push_back(fields_[i].first + ' ' + fields_[i].second);
            }
        }
        return spaced(told, ", ");
    }

  private:
    using Field = std::pair<std::string, std::string>;

    // Numbers of one name behind each other are a vector.
    void put(const char* what, const std::string& value) {
        if (!fields_.empty() && fields_.back().first == what) {
            fields_.back().second += ' ' + value;
        } else {
            fields_.emplace_back(what, value);
        }
    }
    static std::string name_of_type(const char* mangled) {
        int status = 0;
        const std::unique_ptr<char, void (*)(void*)> name(
            abi::__cxa_demangle(mangled, nullptr, nullptr, &status), std::free);
        const std::string whole = name ? name.get() : mangled;
        return whole.substr(whole.rfind(':') + 1);
    }

    std::vector<Field> fields_;
};

/// What a lesson declared beside what one declares that says nothing.
inline std::string told_description(const LessonDescription& given,
                                    const LessonDescription& usual) {
    TextWriter told;
    TextWriter beside;
    wire::description(told, given);
    wire::description(beside, usual);
    return told.told_beside(beside);
}

/// What it wants of a frame.
inline std::string told_reply(const LessonReply& given) {
    TextWriter told;
    TextWriter beside;
    wire::reply(told, given, {});
    const LessonReply nothing;
    wire::reply(beside, nothing, {});
    return told.told_beside(beside);
}

}  // namespace fulcrum::runtime::test
