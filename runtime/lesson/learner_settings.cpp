#include "runtime/lesson/learner_settings.h"

#include "runtime/lesson/hand_fit.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr const char* kScreen = "screen";  // no device is called so

// Which hand it is holds with every device.
std::string device_of(const SettingRow& row) {
    return row.kind == SettingKind::hand ? kAnyDevice : kScreen;
}

}  // namespace

ScreenSettings find_settings(const ProgressData& data, const LearnerId& learner,
                             const ScreenSettings& usual) {
    ScreenSettings found = usual;
    for (const HandSetting& fact : data.hands) {
        for (const SettingRow& row : kScreenSettings) {
            if (fact.learner == learner && fact.device == device_of(row) && fact.name == row.name) {
                const auto* const end = row.steps.begin() + row.n_steps;
                const auto* const step = std::find(row.steps.begin(), end, fact.value);
                // Behind the last step there is none, which changes nothing.
                found.set(row.kind, static_cast<int>(step - row.steps.begin()));
            }
        }
    }
    return found;
}

std::optional<ScreenSettings> read_settings(ProgressStore& store, const std::string& nickname,
                                            const ScreenSettings& usual) {
    if (nickname.empty()) {
        return std::nullopt;
    }
    const auto data = store.read({nickname, {}});
    return data && !data->learners.empty() ? find_settings(*data, data->learners.front().id, usual)
                                           : usual;
}

Expected<void> keep_settings(ProgressStore& store, const std::string& nickname,
                             const ScreenSettings& before, const ScreenSettings& chosen) {
    if (nickname.empty() || chosen == before) {
        return {};
    }
    return store.enrol(nickname).and_then([&](const Learner& learner) -> Expected<void> {
        for (const SettingRow& row : kScreenSettings) {
            const auto step = static_cast<std::size_t>(chosen.step(row.kind));
            if (chosen.step(row.kind) == before.step(row.kind)) {
                continue;
            }
            if (auto kept = store.add_hand_setting({random_record_id(), learner.id, device_of(row),
                                                    std::string(row.name),
                                                    std::string(row.steps.at(step)), utc_now_ms()});
                !kept) {
                return kept;
            }
        }
        return {};
    });
}

}  // namespace fulcrum::runtime
