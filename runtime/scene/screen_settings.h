// What a learner can choose of picture, words and sound: a few things, each with a few steps.
//
// Thread: a value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fulcrum::runtime {

enum class SettingKind : std::uint8_t { sound, voice, text_size, contrast, motion, hand, language };

/// Of the window's words; the lesson itself is English.
enum class Language : std::uint8_t { english, spanish, korean };
/// Those into which words are put.
inline constexpr std::array kHomeLanguages{Language::spanish, Language::korean};

/// One of them. Its name and its steps' names are how it is kept, and with "settings." before them its words (assets/words).
struct SettingRow {
    SettingKind kind;
    std::string_view name;
    std::array<std::string_view, 4> steps;
    int n_steps;
    int usual;  ///< the step of who has chosen none
};

/// A language's code of two letters is its step's name. In their order on the screen and in SettingKind.
inline constexpr std::array<SettingRow, 7> kScreenSettings{{
    {SettingKind::sound, "sound", {"off", "quiet", "loud"}, 3, 2},
    {SettingKind::voice, "voice", {"off", "slow", "usual", "quick"}, 4, 2},
    {SettingKind::text_size, "text", {"usual", "large", "largest"}, 3, 0},
    {SettingKind::contrast, "contrast", {"usual", "high"}, 2, 0},
    {SettingKind::motion, "motion", {"usual", "calm"}, 2, 0},
    {SettingKind::hand, "handed", {"right", "left"}, 2, 0},
    {SettingKind::language, "language", {"en", "es", "ko"}, 3, 0},
}};

/// How words and papers look, as the learner has chosen.
struct ViewLook {
    double text_scale = 1.0;  ///< times their usual size, where there is room for it
    bool high_contrast = false;
};

class ScreenSettings {
  public:
    [[nodiscard]] constexpr int step(SettingKind kind) const { return steps_[index(kind)]; }
    /// One that there is not changes nothing.
    constexpr void set(SettingKind kind, int step) {
        if (step >= 0 && step < kScreenSettings[index(kind)].n_steps) {
            steps_[index(kind)] = step;
        }
    }
    /// The next step; the first after the last.
    constexpr void go_on(SettingKind kind) {
        set(kind, (step(kind) + 1) % kScreenSettings[index(kind)].n_steps);
    }

    // What the steps mean.
    /// Of all that is heard, 0 to 1 of its amplitude.
    [[nodiscard]] constexpr double volume() const {
        return std::array{0.0, 0.3, 1.0}[index_of_step(SettingKind::sound)];
    }
    /// As VoiceSettings has it, where something is said at all.
    [[nodiscard]] constexpr double voice_speed() const {
        return std::array{0.0, 0.7, 0.9, 1.15}[index_of_step(SettingKind::voice)];
    }
    [[nodiscard]] constexpr bool speaks() const { return step(SettingKind::voice) > 0; }
    /// Times the usual size of words.
    [[nodiscard]] constexpr double text_scale() const {
        return std::array{1.0, 1.2, 1.4}[index_of_step(SettingKind::text_size)];
    }
    [[nodiscard]] constexpr bool high_contrast() const { return step(SettingKind::contrast) > 0; }
    [[nodiscard]] constexpr bool calm() const { return step(SettingKind::motion) > 0; }
    [[nodiscard]] constexpr bool left_handed() const { return step(SettingKind::hand) > 0; }
    [[nodiscard]] constexpr Language language() const {
        return static_cast<Language>(step(SettingKind::language));
    }

    friend constexpr bool operator==(const ScreenSettings&, const ScreenSettings&) = default;

  private:
    [[nodiscard]] static constexpr std::size_t index(SettingKind kind) {
        return static_cast<std::size_t>(kind);
    }
    [[nodiscard]] constexpr std::size_t index_of_step(SettingKind kind) const {
        return static_cast<std::size_t>(step(kind));
    }

    std::array<int, kScreenSettings.size()> steps_ = [] {
        std::array<int, kScreenSettings.size()> usual{};
        for (std::size_t i = 0; i < kScreenSettings.size(); ++i) {
            usual[i] = kScreenSettings[i].usual;
        }
        return usual;
    }();
};

}  // namespace fulcrum::runtime
