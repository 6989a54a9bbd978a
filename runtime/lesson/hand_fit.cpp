#include "runtime/lesson/hand_fit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr std::string_view kHanded = "handed";
constexpr std::size_t kLongestVerdict_bytes = 200;

std::optional<double> number_of(std::string_view text) {
    double value = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_whole = read.ec == std::errc{} && read.ptr == text.data() + text.size();
    return is_whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string text_of(double value) {
    std::array<char, 32> text{};
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), written.ptr};
}

tl::unexpected<Error> refuse(std::string_view name, const std::string& words, const char* to_do) {
    return fail("the hand's " + std::string(name) + " is \"" + words + "\"", {}, to_do);
}

Expected<void> set_scale(HandFit& fit, const std::string& words) {
    const auto scale = number_of(words);
    if (!scale || *scale < kLeastFitScale || *scale > kMostFitScale) {
        return refuse("scale", words, "give a number from 0.25 to 4");
    }
    fit.scale = scale;
    return {};
}

Expected<void> set_axes(HandFit& fit, const std::string& words) {
    return AxisOrder::read(words).map([&](const AxisOrder& axes) { fit.axes = axes; });
}

Expected<void> set_middle(HandFit& fit, const std::string& words) {
    constexpr const char* kToDo = "give three numbers in metres, each from -0.5 to 0.5: 0.02,0,0";
    Vector3 middle_A = Vector3::Zero();
    std::string_view rest = words;
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = rest.find(',');
        const bool is_last = comma == std::string_view::npos;
        const auto number = number_of(rest.substr(0, comma));
        if (!number || is_last != (i == 2)) {
            return refuse("middle", words, kToDo);
        }
        middle_A(i) = *number;
        rest = is_last ? std::string_view{} : rest.substr(comma + 1);
    }
    if (!validate(DeviceFit{.middle_A = middle_A})) {
        return refuse("middle", words, kToDo);
    }
    fit.middle_A = middle_A;
    return {};
}

Expected<void> set_clutch(HandFit& fit, const std::string& words) {
    const bool is_button = words.size() == 1 && words[0] >= '1' && words[0] <= '8';
    static_assert(kMostClutchButton == 8);
    if (!is_button && words != "none") {
        return refuse("clutch", words, "name a button of the arm, 1 to 8, or none");
    }
    fit.clutch_button = is_button ? words[0] - '0' : 0;
    return {};
}

Expected<void> set_handed(HandFit& fit, const std::string& words) {
    if (words != "left" && words != "right") {
        return refuse(kHanded, words, "use left or right");
    }
    fit.left_handed = words == "left";
    return {};
}

Expected<void> set_checked(HandFit& fit, const std::string& words) {
    if (words.empty() || words.size() > kLongestVerdict_bytes) {
        return refuse("trial", words, "let its forces be tried again");
    }
    fit.checked = words;
    return {};
}

// Whether a setting is of this learner with this device, or with all.
bool is_of(const HandSetting& setting, const LearnerId& learner, const std::string& device) {
    return setting.learner == learner && (setting.device == device || setting.name == kHanded);
}

}  // namespace

Expected<void> set_fit(HandFit& fit, std::string_view name, const std::string& words) {
    struct Setting {
        std::string_view name;
        Expected<void> (*set)(HandFit&, const std::string&);
    };
    static constexpr std::array<Setting, 6> kSettings{{{"scale", set_scale},
                                                       {"axes", set_axes},
                                                       {"middle", set_middle},
                                                       {"clutch", set_clutch},
                                                       {kHanded, set_handed},
                                                       {"checked", set_checked}}};
    const auto setting = std::ranges::find(kSettings, name, &Setting::name);
    if (setting == kSettings.end()) {
        return fail("a hand has no \"" + std::string(name) + "\"", {},
                    "set its scale, axes, middle, clutch or handed");
    }
    return setting->set(fit, words);
}

std::vector<std::pair<std::string, std::string>> words_of(const HandFit& fit) {
    std::vector<std::pair<std::string, std::string>> words;
    if (fit.scale) {
        words.emplace_back("scale", text_of(*fit.scale));
    }
    if (fit.axes) {
        words.emplace_back("axes", fit.axes->text());
    }
    if (fit.middle_A) {
        words.emplace_back("middle", text_of(fit.middle_A->x()) + "," + text_of(fit.middle_A->y()) +
                                         "," + text_of(fit.middle_A->z()));
    }
    if (fit.clutch_button) {
        words.emplace_back("clutch",
                           *fit.clutch_button == 0 ? "none" : std::to_string(*fit.clutch_button));
    }
    if (fit.left_handed) {
        words.emplace_back(kHanded, *fit.left_handed ? "left" : "right");
    }
    if (!fit.checked.empty()) {
        words.emplace_back("checked", fit.checked);
    }
    return words;
}

HandFit join(const HandFit& first, const HandFit& second) {
    HandFit all = second;
    for (const auto& [name, words] : words_of(first)) {
        // It said so itself.
        (void)set_fit(all, name, words);
    }
    return all;
}

DeviceFit device_fit(const HandFit& fit) {
    return {.axes = fit.axes.value_or(AxisOrder{}),
            .middle_A = fit.middle_A.value_or(Vector3::Zero()),
            .clutch_button = fit.clutch_button.value_or(0),
            .left_handed = fit.left_handed.value_or(false)};
}

KeptFit find_fit(const ProgressData& data, const LearnerId& learner, const std::string& device) {
    KeptFit kept;
    for (const HandSetting& setting : data.hands) {
        if (is_of(setting, learner, device)) {
            if (const auto good = set_fit(kept.fit, setting.name, setting.value); !good) {
                kept.notices.push_back("What is kept of this hand cannot be used: " +
                                       to_sentence(good.error()));
            }
        }
    }
    return kept;
}

KeptFit read_fit(ProgressStore& store, const Learner& learner, const std::string& device) {
    const auto data = store.read({learner.nickname, {}});
    if (!data) {
        return {{}, {to_sentence(data.error())}};
    }
    return find_fit(*data, learner.id, device);
}

Expected<void> keep_fit(ProgressStore& store, const Learner& learner, const std::string& device,
                        const HandFit& fit) {
    const auto kept = words_of(read_fit(store, learner, device).fit);
    for (const auto& [name, words] : words_of(fit)) {
        if (std::ranges::find(kept, std::pair(name, words)) != kept.end()) {
            continue;
        }
        const std::string& with = name == kHanded ? std::string(kAnyDevice) : device;
        if (auto done = store.add_hand_setting(
                {random_record_id(), learner.id, with, name, words, utc_now_ms()});
            !done) {
            return done;
        }
    }
    return {};
}

}  // namespace fulcrum::runtime
