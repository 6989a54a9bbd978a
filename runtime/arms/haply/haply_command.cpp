#include "runtime/arms/haply/haply_command.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace fulcrum::runtime {
namespace {

// Micronewtons: finer than any motor, and never an exponent.
constexpr int kForceDigits = 6;
constexpr double kMostWritten_N = 1000.0;

void append_newtons(double newtons, std::string& out) {
    std::array<char, 64> text{};
    const auto written = std::to_chars(text.data(), text.data() + text.size(),
                                       std::clamp(newtons, -kMostWritten_N, kMostWritten_N),
                                       std::chars_format::fixed, kForceDigits);
    out.append(text.data(), written.ptr);
}

}  // namespace

std::string_view name_of(ForceWord word) noexcept {
    return word == ForceWord::vector ? "vector" : "values";
}

std::optional<ForceWord> choose_force_word(std::string_view version) noexcept {
    if (version.starts_with('v')) {
        version.remove_prefix(1);
    }
    int major = 0;
    int minor = 0;
    const char* const end = version.data() + version.size();
    const auto first = std::from_chars(version.data(), end, major);
    if (first.ec != std::errc{} || first.ptr == end || *first.ptr != '.') {
        return std::nullopt;
    }
    const auto second = std::from_chars(first.ptr + 1, end, minor);
    if (second.ec != std::errc{} || major != 3 || minor < 1) {
        return std::nullopt;
    }
    return minor >= 5 ? ForceWord::vector : ForceWord::values;
}

bool is_haply_id(std::string_view id) noexcept {
    constexpr std::size_t kMostLetters = 64;
    return !id.empty() && id.size() <= kMostLetters && std::ranges::all_of(id, [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               c == '-' || c == '_';
    });
}

void write_haply_command(std::string_view id, ForceWord word, const Vector3& force_A,
                         bool wants_all, std::string& out) {
    const Vector3 force = is_finite(force_A) ? force_A : Vector3::Zero();
    out = wants_all ? R"({"session":{"force_render_full_state":{}},)" : "{";
    out += R"("inverse3":[{"device_id":")";
    out += id;
    out += R"(","commands":{"set_cursor_force":{")";
    out += name_of(word);
    out += R"(":{"x":)";
    append_newtons(force.x(), out);
    out += R"(,"y":)";
    append_newtons(force.y(), out);
    out += R"(,"z":)";
    append_newtons(force.z(), out);
    out += "}}}}]}";
}

}  // namespace fulcrum::runtime
