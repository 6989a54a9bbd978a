#include "runtime/progress/guest_name.h"

#include "runtime/progress/records.h"

#include <algorithm>
#include <array>
#include <ctime>

namespace fulcrum::runtime {
namespace {

// 0 stands for a digit, x for one of sixteen.
constexpr std::string_view kForm = "guest 0000-00-00 00:00 xxxxxxxx";
constexpr std::size_t kChance = 8;

}  // namespace

std::string guest_name_at(std::int64_t utc_ms, std::string_view id) {
    const auto seconds = static_cast<std::time_t>(utc_ms / 1000);
    std::tm local{};
    ::localtime_r(&seconds, &local);
    std::array<char, kForm.size() + 1> text{};
    const std::size_t length =
        std::strftime(text.data(), text.size(), "guest %Y-%m-%d %H:%M ", &local);
    return std::string(text.data(), length).append(id.substr(0, kChance));
}

std::string new_guest_name() {
    return guest_name_at(utc_now_ms(), random_record_id());
}

bool is_guest_name(std::string_view nickname) noexcept {
    const auto fits = [](char form, char c) {
        const bool digit = c >= '0' && c <= '9';
        return form == '0' ? digit : form == 'x' ? digit || (c >= 'a' && c <= 'f') : c == form;
    };
    return std::ranges::equal(kForm, nickname, fits);
}

}  // namespace fulcrum::runtime
