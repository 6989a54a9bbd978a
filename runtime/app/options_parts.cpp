#include "runtime/app/options_parts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace fulcrum::runtime {
namespace {

constexpr double kMostProcess = 4194304.0;  // PID_MAX_LIMIT, proc(5)

// Behind a second --hand it is that one's.
std::string& key_place(Options& options) {
    if (options.hands.size() < 2) {
        return options.arm.key_file;
    }
    options.more_keys.resize(options.hands.size() - 1);
    return options.more_keys.back();
}

}  // namespace

Expected<double> number_in(const std::string& flag, const std::string& text, double low,
                           double high) {
    double value = 0.0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size() ||
        !(value >= low && value <= high)) {
        const auto shown = [](double x) {
            std::string s = std::to_string(x);
            s.erase(s.find_last_not_of('0') + 1);
            return s.back() == '.' ? s.substr(0, s.size() - 1) : s;
        };
        return fail(flag + " is \"" + text + "\"", "",
                    "give a number from " + shown(low) + " to " + shown(high));
    }
    return value;
}

std::optional<Expected<void>> set_fit_value(Options& options, const std::string& flag,
                                            const std::string& value) {
    if (flag == "--first-use") {
        if (value != "once" && value != "again" && value != "never") {
            return fail("--first-use " + value + " is not known", "", "use once, again or never");
        }
        options.first_use = value == "once"    ? FirstUseTrial::once
                            : value == "again" ? FirstUseTrial::again
                                               : FirstUseTrial::never;
        return Expected<void>{};
    }
    constexpr std::array<std::string_view, 5> kFlags{"--scale", "--axes", "--middle", "--clutch",
                                                     "--handed"};
    if (std::ranges::find(kFlags, flag) == kFlags.end()) {
        return std::nullopt;
    }
    constexpr std::size_t kDashes = 2;
    const std::string_view name = std::string_view(flag).substr(kDashes);
    // Behind a second --hand it is said of that one's device; which hand a person writes with is one thing for all.
    if (options.hands.size() < 2 || name == "handed") {
        return set_fit(options.fit, name, value);
    }
    options.more_fits.resize(options.hands.size() - 1);
    return set_fit(options.more_fits.back(), name, value);
}

namespace {

Expected<void> set_only_process(Options& options, const std::string& flag,
                                const std::string& value) {
    return number_in(flag, value, 1.0, kMostProcess).and_then([&](double id) -> Expected<void> {
        options.only_process = static_cast<int>(id);
        // A part of a number would be another process.
        return *options.only_process == id
                   ? Expected<void>{}
                   : fail(flag + " is \"" + value + "\"", "", "give a process's number");
    });
}

}  // namespace

std::optional<Expected<void>> set_arm_value(Options& options, const std::string& flag,
                                            const std::string& value) {
    ArmOptions& arm = options.arm;
    if (flag == "--address" || flag == "--key") {
        (flag == "--key" ? key_place(options) : arm.address) = value;
        return Expected<void>{};
    }
    if (flag == "--only") {
        return set_only_process(options, flag, value);
    }
    if (flag == "--seeds") {
        return number_in(flag, value, 1.0, 1.0e6).map([&](double n) {
            options.seeds = static_cast<std::uint64_t>(n);
        });
    }
    if (flag == "--arm") {
        if (value != "wam" && value != "desktop") {
            return fail("--arm " + value + " is not known", "", "use wam or desktop");
        }
        arm.kind = value == "wam" ? ArmKind::wam : ArmKind::desktop;
        return Expected<void>{};
    }
    if (flag == "--motion") {
        if (value != "still" && value != "circle") {
            return fail("--motion " + value + " is not known", "", "use still or circle");
        }
        arm.motion = value == "circle" ? ArmMotion::circle : ArmMotion::still;
        return Expected<void>{};
    }
    struct Number {
        std::string_view flag;
        double low, high, factor;
        void (*set)(ArmOptions&, double);
    };
    constexpr double kPercent = 0.01;
    constexpr double kMilli = 0.001;
    static constexpr std::array<Number, 9> kNumbers{{
        {"--port", 0.0, 65535.0, 1.0,
         [](ArmOptions& a, double x) { a.port = static_cast<std::uint16_t>(x); }},
        {"--rate", 500.0, 2000.0, 1.0, [](ArmOptions& a, double x) { a.rate_Hz = x; }},
        {"--loss", 0.0, 100.0, kPercent, [](ArmOptions& a, double x) { a.faults.loss = x; }},
        {"--burst", 1.0, 1000.0, 1.0,
         [](ArmOptions& a, double x) { a.faults.burst = static_cast<int>(x); }},
        {"--delay", 0.0, 1000.0, kMilli, [](ArmOptions& a, double x) { a.faults.delay_s = x; }},
        {"--jitter", 0.0, 1000.0, kMilli, [](ArmOptions& a, double x) { a.faults.jitter_s = x; }},
        {"--reorder", 0.0, 100.0, kPercent, [](ArmOptions& a, double x) { a.faults.reorder = x; }},
        {"--duplicate", 0.0, 100.0, kPercent,
         [](ArmOptions& a, double x) { a.faults.duplicate = x; }},
        {"--corrupt", 0.0, 100.0, kPercent, [](ArmOptions& a, double x) { a.faults.corrupt = x; }},
    }};
    const auto number = std::find_if(kNumbers.begin(), kNumbers.end(),
                                     [&](const Number& n) { return n.flag == flag; });
    if (number == kNumbers.end()) {
        return std::nullopt;
    }
    return number_in(flag, value, number->low, number->high).map([&](double x) {
        number->set(arm, x * number->factor);
    });
}

}  // namespace fulcrum::runtime
