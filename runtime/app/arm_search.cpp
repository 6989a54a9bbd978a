#include "runtime/app/arm_search.h"

#include "haptics/base/clock.h"
#include "runtime/app/own_arm.h"

#include <memory>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kLetGo_s = 2.0;

}  // namespace

DeviceEntry read_arm_entry(const OwnArmKind& kind, const std::vector<std::string>& lines) {
    DeviceEntry entry;
    entry.name = kind.name;
    entry.kind = "arm";
    entry.hand = kind.word;
    entry.missing = "its program says nothing";
    for (const std::string& line : lines) {
        if (line.starts_with(kArmNamed)) {
            entry.name = line.substr(kArmNamed.size());
        } else if (line.starts_with(kArmAt)) {
            entry.usable = true;
            entry.axes = entry.force_axes = 3;
            entry.missing.clear();
        } else if (line.starts_with(kArmError)) {
            entry.missing = line.substr(kArmError.size());
            // The list ends its sentences itself.
            if (entry.missing.ends_with('.')) {
                entry.missing.pop_back();
            }
        }
    }
    return entry;
}

std::vector<DeviceEntry> find_makers_arms() {
    std::vector<std::pair<const OwnArmKind*, std::unique_ptr<LineProgram>>> asked;
    for (const OwnArmKind& kind : kOwnArms) {
        if (!kind.is_real) {
            continue;
        }
        std::vector<std::string> words = arm_words(kind);
        words.insert(words.end(), {"--port", "0"});
        auto program = LineProgram::start(words, kArmEnvironment);
        asked.emplace_back(&kind, program ? std::move(*program) : nullptr);
    }
    std::vector<DeviceEntry> entries;
    const double until_s = monotonic_now_s() + kArmBegin_s;
    for (const auto& [kind, program] : asked) {
        entries.push_back(read_arm_entry(
            *kind, program ? hear_beginning(*program, until_s) : std::vector<std::string>()));
        if (program) {
            program->finish(kLetGo_s);
        }
    }
    return entries;
}

}  // namespace fulcrum::runtime
