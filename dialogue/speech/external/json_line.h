// One JSON object a line, as programs beside this one are spoken to. For the sources of this folder alone: each that sees the library costs
// seconds to compile.
//
// Thread: pure.  Cost: linear in the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::dialogue {

using Json = nlohmann::json;

/// An object, not nested deeply and no longer than that; null where it is none.
inline Json parse_line(std::string_view line, std::size_t most_bytes) {
    constexpr int kMostDepth = 4;
    if (line.size() > most_bytes) {
        return {};
    }
    bool is_deep = false;
    const auto guard = [&](int depth, Json::parse_event_t /*event*/, Json& /*parsed*/) {
        is_deep = is_deep || depth > kMostDepth;
        return !is_deep;
    };
    Json json = Json::parse(line, guard, false);
    return json.is_object() && !is_deep ? json : Json{};
}

/// From -1 to a milliard.
inline std::optional<int> whole_number(const Json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number_integer()) {
        return {};
    }
    const auto value = found->get<std::int64_t>();
    constexpr std::int64_t kMost = 1'000'000'000;
    return value >= -1 && value <= kMost ? std::optional(static_cast<int>(value)) : std::nullopt;
}

inline std::optional<std::string> text_of(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? std::optional(found->get<std::string>())
                                                       : std::nullopt;
}

/// Bytes that are no UTF-8 become question marks.
inline std::string to_text(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace fulcrum::dialogue
