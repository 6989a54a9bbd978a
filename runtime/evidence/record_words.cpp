#include "runtime/evidence/record_words.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kSlant = 0.38;  // sine of 22.5 degrees: what lies nearer to an axis is along it

const char* effect_word(Effect effect) {
    constexpr const char* kWords[] = {"tool",  "tool damping", "contact", "contact damping",
                                      "grip",  "texture",      "tap",     "weight",
                                      "force", "kite line",    "lesson",  "brake"};
    static_assert(std::size(kWords) == kEffectKinds);
    return kWords[static_cast<std::size_t>(effect)];
}

}  // namespace

std::vector<std::string> effect_words(std::span<const EffectSlot> effects,
                                      const LessonDescription& lesson) {
    std::vector<std::string> words;
    words.reserve(effects.size());
    for (const EffectSlot& slot : effects) {
        std::string word = effect_word(slot.effect);
        if (slot.effect == Effect::field) {
            const auto field = static_cast<std::size_t>(slot.field);
            word += " " + (field < lesson.forces.size() ? lesson.forces[field].name
                                                        : std::to_string(field + 1));
        }
        words.push_back(std::move(word));
    }
    return words;
}

std::string_view gate_word(GatePhase phase) noexcept {
    constexpr std::string_view kWords[] = {"waiting", "rising", "open", "fading", "stopped"};
    return kWords[static_cast<std::size_t>(phase)];
}

std::string fault_words(Fault faults) {
    constexpr std::string_view kWords[] = {"no pose from the device",
                                           "pose too old",
                                           "impossible pose",
                                           "lesson or world silent",
                                           "impossible force",
                                           "emergency stop",
                                           "lesson failed",
                                           "record full",
                                           "device took no force",
                                           "run ended",
                                           "hand too fast",
                                           "too much energy",
                                           "clutch held",
                                           "another hand stopped"};
    std::string text;
    for (std::size_t bit = 0; bit < std::size(kWords); ++bit) {
        if (any(faults & static_cast<Fault>(1U << bit))) {
            text += (text.empty() ? "" : ", ") + std::string(kWords[bit]);
        }
    }
    return text.empty() ? "none" : text;
}

std::string_view event_word(RecordEventKind kind) noexcept {
    constexpr std::string_view kWords[] = {"note",     "dropped",  "caught",  "landed", "released",
                                           "asked",    "answered", "touched", "failed", "placed",
                                           "hidden",   "held",     "pressed", "wheel",  "said",
                                           "switched", "gate",     "fault",   "cut",    "finished"};
    static_assert(std::size(kWords) == static_cast<std::size_t>(kLastRecordEvent) + 1);
    return kWords[static_cast<std::size_t>(kind)];
}

std::string_view where_word(BodyWhere where) noexcept {
    constexpr std::string_view kWords[] = {"hidden", "placed", "falling", "held", "landed"};
    return kWords[static_cast<std::size_t>(where)];
}

std::vector<int> main_axes(const Vector3& force_W) {
    const double length = compute_length(force_W);
    std::vector<int> axes;
    if (!(length > 0.0) || !std::isfinite(length)) {
        return axes;
    }
    std::array<int, 3> order{0, 1, 2};
    std::ranges::stable_sort(
        order, [&](int a, int b) { return std::abs(force_W[a]) > std::abs(force_W[b]); });
    for (const int axis : order) {
        if (axes.empty() || std::abs(force_W[axis]) > kSlant * length) {
            axes.push_back(force_W[axis] > 0.0 ? axis + 1 : -axis - 1);
        }
    }
    return axes;
}

std::string direction_words(const Vector3& force_W) {
    constexpr std::array<std::pair<const char*, const char*>, 3> kWays{
        {{"right", "left"}, {"up", "down"}, {"towards you", "away from you"}}};
    std::string text;
    for (const int axis : main_axes(force_W)) {
        const auto& [more, less] = kWays[static_cast<std::size_t>(std::abs(axis) - 1)];
        text += (text.empty() ? "" : " and ") + std::string(axis > 0 ? more : less);
    }
    return text.empty() ? "-" : text;
}

std::string exact_text(double value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

}  // namespace fulcrum::runtime
