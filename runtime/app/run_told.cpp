#include "runtime/app/run_told.h"

#include "runtime/app/installation.h"
#include "runtime/app/tool_lacks.h"

#include <array>
#include <cstdio>

namespace fulcrum::runtime {

std::vector<std::string> find_losses(LessonRun& run) {
    std::vector<std::string> sentences;
    const auto tell = [&](std::uint64_t n, const char* what) {
        if (n > 0) {
            sentences.push_back(std::to_string(n) + " " + what);
        }
    };
    tell(run.n_rounds_dropped(), "rounds are missing in the record: the disk was too slow.");
    tell(run.effects().n_events_dropped(),
         "catches or landings were not told to the lesson: it answered too slowly.");
    tell(run.effects().n_commands_ignored(),
         "commands to bodies were ignored: no such body, or no finite place.");
    tell(run.effects().world_effort().n_unconverged, kUnconvergedWords);
    if (const auto link = run.hand().link_status()) {
        constexpr double kMilli = 1.0e3;
        std::array<char, 240> text{};
        std::snprintf(text.data(), text.size(),
                      "The arm's link: round trip %.2f ms, clocks differ by %.3f s, made %llu %s, "
                      "%llu states taken, %llu packets refused.",
                      kMilli * link->round_trip_s, link->offset_s,
                      static_cast<unsigned long long>(link->sessions),
                      link->sessions == 1 ? "time" : "times",
                      static_cast<unsigned long long>(link->counts.received[0]),
                      static_cast<unsigned long long>(link->counts.refused()));
        sentences.emplace_back(text.data());
    }
    const ToolEffort& tool = run.channels().state_for_lesson.value().tool;
    if (tool.n_inexact > 0) {
        std::array<char, 160> text{};
        std::snprintf(text.data(), text.size(),
                      "steps of the tool looked at a part of its points, to end in time: their "
                      "force may have been off by up to %.2g N.",
                      tool.most_error_N);
        tell(tool.n_inexact, text.data());
    }
    tell(tool.n_cut, "steps of the tool ended before its solver did, to end in time.");
    for (std::size_t i = 0; i < kToolLacks; ++i) {
        tell(tool.n_lacking[i],
             (std::string("steps of the tool ") + kToolLackWords[i] + ".").c_str());
    }
    if (const ContactLateness* const late = run.haptic_loop().contact_lateness();
        late != nullptr && late->n_late() > 0) {
        std::array<char, 160> text{};
        std::snprintf(text.data(), text.size(),
                      "steps of the tool gave less force, for contact was found too late: what was "
                      "known of it was up to %.0f ms old.",
                      1e3 * late->age().max_s());
        tell(late->n_late(), text.data());
    }
    return sentences;
}

void print_lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        std::puts(line.c_str());
    }
    if (!lines.empty()) {
        (void)std::fflush(stdout);
    }
}

void say_notices(const LessonRun& run) {
    say_all(run.plan().notices);
}

void say_losses(LessonRun& run) {
    say_all(find_losses(run));
}

}  // namespace fulcrum::runtime
