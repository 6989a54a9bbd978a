#include "haptics/device/hid/force_layout.h"

#include <algorithm>
#include <string>

namespace fulcrum::hid {
namespace {

constexpr std::uint16_t kPhysical = 0x0F;
constexpr Usage pid(std::uint16_t id) {
    return usage_of(kPhysical, id);
}
// Reports.
constexpr Usage kSetEffect = pid(0x21);
constexpr Usage kSetConstantForce = pid(0x73);
constexpr Usage kEffectOperationReport = pid(0x77);
constexpr Usage kDeviceGainReport = pid(0x7D);
constexpr Usage kBlockLoad = pid(0x89);
constexpr Usage kBlockFree = pid(0x90);
constexpr Usage kDeviceControlReport = pid(0x95);
constexpr Usage kCreateNewEffect = pid(0xAB);
// What stands in them.
constexpr Usage kEffectBlockIndex = pid(0x22);
constexpr Usage kConstantForce = pid(0x26);
constexpr Usage kDuration = pid(0x50);
constexpr Usage kGain = pid(0x52);
constexpr Usage kAxesEnable = pid(0x55);
constexpr Usage kDirectionEnable = pid(0x56);
constexpr Usage kDirection = pid(0x57);
constexpr Usage kMagnitude = pid(0x70);
constexpr Usage kStart = pid(0x79);
constexpr Usage kStop = pid(0x7B);
constexpr Usage kLoopCount = pid(0x7C);
constexpr Usage kDeviceGain = pid(0x7E);
constexpr Usage kLoadSuccess = pid(0x8C);
constexpr Usage kEnableActuators = pid(0x97);
constexpr Usage kStopAll = pid(0x99);
constexpr Usage kReset = pid(0x9A);
constexpr Usage kX = usage_of(0x01, 0x30);
constexpr Usage kY = usage_of(0x01, 0x31);
constexpr std::uint16_t kOrdinal = 0x0A;

// Looks in one report of the descriptor at a time, and remembers the first thing that was missing.
class LayoutSearch {
  public:
    explicit LayoutSearch(const ReportDescriptor& descriptor) : descriptor_(descriptor) {}

    // The number `usage` of report `report`.
    [[nodiscard]] std::optional<ReportField> number(Usage report, Usage usage) const {
        const auto& fields = descriptor_.fields();
        const auto found = std::find_if(fields.begin(), fields.end(), [&](const ReportField& f) {
            return f.type != ReportType::input && !f.is_array && f.usage == usage &&
                   descriptor_.is_within(f, report);
        });
        return found == fields.end() ? std::nullopt : std::optional(*found);
    }

    // The way to say `usage` in report `report`: as an entry of an array, or as a bit.
    [[nodiscard]] std::optional<ForceOrder> order(Usage report, Usage usage) const {
        for (const ReportField& field : descriptor_.fields()) {
            if (field.type == ReportType::input || !field.is_array ||
                !descriptor_.is_within(field, report)) {
                continue;
            }
            if (const std::int64_t value = descriptor_.value_of(field, usage); value >= 0) {
                return ForceOrder{field, value};
            }
        }
        if (const auto bit = number(report, usage)) {
            return ForceOrder{*bit, 1};
        }
        return std::nullopt;
    }

    // The first number of report `report` inside the collection `part`.
    [[nodiscard]] std::optional<ReportField> part(Usage report, Usage part, Usage usage) const {
        for (const ReportField& field : descriptor_.fields()) {
            if (!field.is_array && field.usage == usage && descriptor_.is_within(field, report) &&
                descriptor_.is_within(field, part)) {
                return field;
            }
        }
        return std::nullopt;
    }

    void need(Usage report, Usage usage, const char* name, ReportField& into) {
        keep(number(report, usage), name, into);
    }
    void need(Usage report, Usage usage, const char* name, ForceOrder& into) {
        keep(order(report, usage), name, into);
    }
    [[nodiscard]] const std::string& missing() const noexcept { return missing_; }

  private:
    template <class T>
    void keep(const std::optional<T>& found, const char* name, T& into) {
        if (found) {
            into = *found;
        } else if (missing_.empty()) {
            missing_ = name;
        }
    }

    const ReportDescriptor& descriptor_;
    std::string missing_;
};

tl::unexpected<Error> refuse(const std::string& why) {
    return fail("its force cannot be used: " + why, {},
                "use it without force, or a joystick with HID PID constant force");
}

}  // namespace

bool mentions_force(const ReportDescriptor& descriptor) noexcept {
    const auto& collections = descriptor.collections();
    return std::any_of(collections.begin(), collections.end(), [](const Collection& collection) {
        return collection.usage >> 16U == kPhysical;
    });
}

Expected<ForceLayout> ForceLayout::find(const ReportDescriptor& descriptor) {
    LayoutSearch search(descriptor);
    ForceLayout layout;
    search.need(kCreateNewEffect, kConstantForce, "constant force", layout.create_constant);
    search.need(kBlockLoad, kEffectBlockIndex, "the index in Block Load", layout.loaded_index);
    search.need(kBlockLoad, kLoadSuccess, "the success of Block Load", layout.load_success);
    search.need(kSetEffect, kEffectBlockIndex, "the index in Set Effect", layout.effect_index);
    search.need(kSetEffect, kConstantForce, "constant force in Set Effect", layout.effect_constant);
    search.need(kSetEffect, kDuration, "a duration, so that its forces would never end",
                layout.duration);
    search.need(kSetConstantForce, kEffectBlockIndex, "the index in Set Constant Force",
                layout.force_index);
    search.need(kSetConstantForce, kMagnitude, "a magnitude", layout.magnitude);
    search.need(kEffectOperationReport, kEffectBlockIndex, "the index in Effect Operation",
                layout.operation_index);
    search.need(kEffectOperationReport, kStart, "Start", layout.start);
    search.need(kEffectOperationReport, kStop, "Stop", layout.stop);
    if (!search.missing().empty()) {
        return refuse("it has not " + search.missing());
    }
    if (!descriptor.numbers_reports()) {
        return refuse("its reports have no numbers");
    }
    if (layout.magnitude.logical_min >= 0 || layout.magnitude.logical_max <= 0) {
        return refuse("its magnitude has one sign only");
    }
    layout.effect_gain = search.number(kSetEffect, kGain);
    layout.direction_enable = search.number(kSetEffect, kDirectionEnable);
    layout.direction = search.part(kSetEffect, kDirection, usage_of(kOrdinal, 1));
    layout.enable_x = search.part(kSetEffect, kAxesEnable, kX);
    layout.enable_y = search.part(kSetEffect, kAxesEnable, kY);
    layout.loop_count = search.number(kEffectOperationReport, kLoopCount);
    layout.enable_actuators = search.order(kDeviceControlReport, kEnableActuators);
    layout.stop_all = search.order(kDeviceControlReport, kStopAll);
    layout.reset = search.order(kDeviceControlReport, kReset);
    layout.device_gain = search.number(kDeviceGainReport, kDeviceGain);
    layout.freed_index = search.number(kBlockFree, kEffectBlockIndex);
    // Who names no axes to enable has both of a joystick's; along two the direction must be told.
    const bool names_axes = layout.enable_x || layout.enable_y;
    layout.has_x = !names_axes || layout.enable_x;
    layout.has_y = !names_axes || layout.enable_y;
    const bool tells_axis = (layout.direction_enable && layout.direction) || names_axes;
    if (!tells_axis) {
        return refuse("it has no directions");
    }
    return layout;
}

}  // namespace fulcrum::hid
