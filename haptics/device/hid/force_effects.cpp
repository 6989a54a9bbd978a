#include "haptics/device/hid/force_effects.h"

#include "haptics/base/range.h"
#include "haptics/device/hid/report_bits.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace fulcrum::hid {
namespace {

constexpr int kLoadTries = 40;  // a device that has its effects in slow memory needs some of them
constexpr double kFromTheRight_deg = 90.0;
constexpr double kFromAhead_deg = 0.0;

tl::unexpected<Error> refused(const char* step) {
    return fail(std::string("the device did not ") + step, {},
                "unplug it and plug it in again, or use it without force");
}

// Durations are in the unit that the descriptor names, and in milliseconds where it names none.
std::int64_t to_duration(const ReportField& field, double duration_s) {
    constexpr double kMs = 1000.0;
    if (field.unit != 0) {
        return from_physical(field, duration_s);
    }
    return std::clamp(std::int64_t{std::llround(duration_s * kMs)},
                      std::max<std::int64_t>(field.logical_min, 1), field.logical_max);
}

// Bearings are in degrees where the descriptor names a unit, else the range is a turn.
std::int64_t to_bearing(const ReportField& field, double bearing_deg) {
    return field.unit != 0 ? from_physical(field, bearing_deg)
                           : from_share(field, bearing_deg / 360.0);
}

}  // namespace

Expected<void> validate(const ForceEffectSettings& s) {
    const Range ranges[] = {{"device_gain", s.device_gain, 0.05, 1.0},
                            {"duration_s", s.duration_s, 0.1, 1.0},
                            {"load_pause_s", s.load_pause_s, 0.0, 0.1}};
    return check_ranges("the joystick's", ranges);
}

ForceEffects::ForceEffects(const ReportDescriptor& descriptor, const ForceLayout& layout,
                           const ForceEffectSettings& settings)
    : descriptor_(descriptor), layout_(layout), settings_(settings) {}

Expected<void> ForceEffects::begin(HidLink& link) {
    effects_.clear();
    // What somebody else left there goes first; then power, then how much of it.
    if (layout_.reset && !order(link, *layout_.reset)) {
        return refused("take its reset");
    }
    if (layout_.enable_actuators && !order(link, *layout_.enable_actuators)) {
        return refused("switch its motors on");
    }
    if (layout_.device_gain) {
        auto gain = start_report(*layout_.device_gain);
        put(gain, *layout_.device_gain, from_share(*layout_.device_gain, settings_.device_gain));
        if (!send(link, layout_.device_gain->type, gain)) {
            return refused("take its gain");
        }
    }
    for (const bool along_x : {true, false}) {
        if (along_x ? !layout_.has_x : !layout_.has_y) {
            continue;
        }
        if (auto made = make(link, along_x); !made) {
            end(link);
            return made;
        }
    }
    return {};
}

Expected<void> ForceEffects::make(HidLink& link, bool along_x) {
    if (!order(link, layout_.create_constant)) {
        return refused("make a constant force");
    }
    const auto index = load(link);
    if (!index) {
        return tl::unexpected(index.error());
    }
    effects_.push_back({along_x, *index, std::nullopt});
    if (!describe(link, effects_.back()) || !set_magnitude(link, effects_.back(), 0.0)) {
        return refused("take the settings of a constant force");
    }
    if (!operate(link, effects_.back(), layout_.start)) {
        return refused("start a constant force");
    }
    return {};
}

// Where the device has put the effect that was just created.
Expected<std::int64_t> ForceEffects::load(HidLink& link) const {
    const ReportField& index = layout_.loaded_index;
    for (int i = 0; i < kLoadTries; ++i) {
        auto answer = start_report(index);
        const int n = link.get_feature(answer);
        if (n == static_cast<int>(answer.size())) {
            const std::span<const std::uint8_t> data = std::span(answer).subspan(1);
            const auto status = read_value(layout_.load_success.field, data);
            const auto place = read_value(index, data);
            if (status == layout_.load_success.value && place && *place > 0) {
                return *place;
            }
            // Full or wrong: that does not change.
            if (status && *status != layout_.load_success.value &&
                layout_.load_success.field.is_array) {
                return refused("have room for a constant force");
            }
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(settings_.load_pause_s));
    }
    return refused("say where it put a constant force");
}

bool ForceEffects::describe(HidLink& link, const Effect& effect) const {
    auto report = start_report(layout_.effect_index);
    put(report, layout_.effect_index, effect.index);
    put(report, layout_.effect_constant.field, layout_.effect_constant.value);
    put(report, layout_.duration, to_duration(layout_.duration, settings_.duration_s));
    if (layout_.effect_gain) {
        put(report, *layout_.effect_gain, layout_.effect_gain->logical_max);
    }
    if (layout_.direction) {
        put(report, *layout_.direction,
            to_bearing(*layout_.direction, effect.along_x ? kFromTheRight_deg : kFromAhead_deg));
    }
    // Either the direction counts or the axes do.
    if (layout_.direction_enable && layout_.direction) {
        put(report, *layout_.direction_enable, 1);
    } else if (const auto& axis = effect.along_x ? layout_.enable_x : layout_.enable_y) {
        put(report, *axis, 1);
    }
    // No button sets it off: that field stays 0, which is outside its range.
    return send(link, layout_.effect_index.type, report);
}

bool ForceEffects::set(HidLink& link, double x, double y) {
    bool all_taken = true;
    for (Effect& effect : effects_) {
        all_taken = set_magnitude(link, effect, effect.along_x ? x : y) && all_taken;
    }
    return all_taken;
}

bool ForceEffects::set_magnitude(HidLink& link, Effect& effect, double share) {
    const ReportField& field = layout_.magnitude;
    const double held = std::isfinite(share) ? std::clamp(share, -1.0, 1.0) : 0.0;
    const double wanted = -held;
    const auto most = static_cast<double>(wanted < 0.0 ? -field.logical_min : field.logical_max);
    const std::int64_t magnitude = std::llround(wanted * most);
    if (effect.magnitude == magnitude) {
        return true;
    }
    auto report = start_report(layout_.force_index);
    put(report, layout_.force_index, effect.index);
    put(report, field, magnitude);
    // What was not taken is sent again the next time.
    const bool taken = send(link, layout_.force_index.type, report);
    effect.magnitude = taken ? std::optional(magnitude) : std::nullopt;
    return taken;
}

bool ForceEffects::renew(HidLink& link) {
    return std::all_of(effects_.begin(), effects_.end(),
                       [&](const Effect& effect) { return operate(link, effect, layout_.start); });
}

// Each step is tried, whatever became of those before.
void ForceEffects::end(HidLink& link) noexcept {
    for (Effect& effect : effects_) {
        (void)set_magnitude(link, effect, 0.0);
        (void)operate(link, effect, layout_.stop);
    }
    if (layout_.stop_all) {
        (void)order(link, *layout_.stop_all);
    }
    for (const Effect& effect : effects_) {
        if (layout_.freed_index) {
            auto report = start_report(*layout_.freed_index);
            put(report, *layout_.freed_index, effect.index);
            (void)send(link, layout_.freed_index->type, report);
        }
    }
    effects_.clear();
}

bool ForceEffects::operate(HidLink& link, const Effect& effect, const ForceOrder& what) const {
    auto report = start_report(layout_.operation_index);
    put(report, layout_.operation_index, effect.index);
    put(report, what.field, what.value);
    if (layout_.loop_count) {
        put(report, *layout_.loop_count, 1);
    }
    return send(link, layout_.operation_index.type, report);
}

bool ForceEffects::order(HidLink& link, const ForceOrder& what) const {
    auto report = start_report(what.field);
    put(report, what.field, what.value);
    return send(link, what.field.type, report);
}

// A report of zeros of its length, with its number.
std::vector<std::uint8_t> ForceEffects::start_report(const ReportField& field) const {
    std::vector<std::uint8_t> report(descriptor_.report_bytes(field.type, field.report_id), 0);
    report.at(0) = field.report_id;
    return report;
}

void ForceEffects::put(std::vector<std::uint8_t>& report, const ReportField& field,
                       std::int64_t value) const noexcept {
    write_value(field, value, std::span(report).subspan(1));
}

bool ForceEffects::send(HidLink& link, ReportType type, const std::vector<std::uint8_t>& report) {
    return type == ReportType::feature ? link.send_feature(report) : link.write(report);
}

}  // namespace fulcrum::hid
