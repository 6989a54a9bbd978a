#include "runtime/audio/synthesis.h"

#include "runtime/scene/sounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace fulcrum::runtime {
namespace {

// ---- things that are caught

std::vector<float> caught() {
    return Waveform(0.3)
        .add(Mode{180.0, 0.07, 1.0})
        .add(Mode{410.0, 0.04, 0.4})
        .add(Noise{700.0, 0.7, 0.02, 0.5, 11})
        .finish(0.6);
}

/// Low and full, falling a little as the bucket gives way; the hollow rings on at 150 to 180 Hz,
/// which small loudspeakers can still make.
std::vector<float> caught_watermelon() {
    return Waveform(0.8)
        .add(Glide{150.0, 66.0, 0.035, 0.16, 1.0})
        .add(Mode{117.0, 0.19, 0.55}, 0.004)
        .add(Mode{153.0, 0.26, 0.65}, 0.008, 0.006)
        .add(Mode{176.0, 0.20, 0.40}, 0.008, 0.006)
        .add(Mode{268.0, 0.09, 0.25})
        .add(Mode{395.0, 0.05, 0.12})
        .add(Noise{240.0, 0.8, 0.030, 0.9, 23})
        .finish(kPeak);
}

std::vector<float> caught_apple() {
    return Waveform(0.35)
        .add(Mode{262.0, 0.060, 0.9})
        .add(Mode{431.0, 0.055, 1.0})
        .add(Mode{713.0, 0.035, 0.5})
        .add(Mode{1180.0, 0.020, 0.25})
        .add(Noise{1500.0, 0.8, 0.006, 0.8, 37})
        .finish(0.62);
}

std::vector<float> caught_banana() {
    return Waveform(0.3)
        .add(Noise{850.0, 0.6, 0.030, 1.0, 41}, 0.0, 0.003)
        .add(Noise{420.0, 0.8, 0.045, 0.8, 43}, 0.012, 0.004)
        .add(Mode{190.0, 0.045, 0.35})
        .finish(0.5);
}

/// Tick, and the tock of its other end.
std::vector<float> caught_egg() {
    Waveform wave(0.25);
    constexpr double kTock_s = 0.058;
    for (const double start_s : {0.0, kTock_s}) {
        const double loud = start_s == 0.0 ? 1.0 : 0.45;
        const double pitch = start_s == 0.0 ? 1.0 : 0.86;
        wave.add(Mode{2350.0 * pitch, 0.030, loud}, start_s, 0.0005)
            .add(Mode{3720.0 * pitch, 0.022, 0.8 * loud}, start_s, 0.0005)
            .add(Mode{5210.0 * pitch, 0.014, 0.5 * loud}, start_s, 0.0005)
            .add(Mode{7140.0 * pitch, 0.008, 0.3 * loud}, start_s, 0.0005);
    }
    return wave.finish(0.45);
}

// ---- things that fell beside the bucket

/// A soft thump on grass.
std::vector<float> landed() {
    return Waveform(0.35)
        .add(Glide{130.0, 75.0, 0.03, 0.07, 1.0})
        .add(Noise{320.0, 0.6, 0.05, 0.7, 53}, 0.0, 0.004)
        .add(Noise{2600.0, 0.6, 0.03, 0.12, 59}, 0.010, 0.008)
        .finish(0.55);
}

/// Wet: a slap, then three drops.
std::vector<float> splat() {
    return Waveform(0.5)
        .add(Noise{520.0, 0.7, 0.05, 1.0, 61}, 0.0, 0.002)
        .add(Glide{310.0, 120.0, 0.04, 0.06, 0.7})
        .add(Glide{480.0, 900.0, 0.02, 0.018, 0.30}, 0.11, 0.003)
        .add(Glide{620.0, 1150.0, 0.02, 0.016, 0.22}, 0.17, 0.003)
        .add(Glide{550.0, 1000.0, 0.02, 0.014, 0.15}, 0.26, 0.003)
        .finish(0.55);
}

// ---- what the program says

// Equal temperament, A4 = 440 Hz.
constexpr double kE4 = 329.63, kG4 = 392.00, kC5 = 523.25, kE5 = 659.26, kG5 = 783.99,
                 kC6 = 1046.50;

std::vector<float> right() {
    return Waveform(0.75).add_note(kC5, 0.16, 0.8, 0.0).add_note(kG5, 0.22, 1.0, 0.13).finish(0.5);
}

std::vector<float> try_again() {
    return Waveform(0.8).add_note(kG4, 0.18, 0.8, 0.0).add_note(kE4, 0.24, 0.9, 0.20).finish(0.38);
}

std::vector<float> level_up() {
    return Waveform(1.1)
        .add_note(kC5, 0.16, 0.8, 0.0)
        .add_note(kE5, 0.16, 0.8, 0.11)
        .add_note(kG5, 0.18, 0.9, 0.22)
        .add_note(kC6, 0.28, 1.0, 0.33)
        .finish(0.5);
}

/// A little fanfare: three quick notes, a long one, and the chord.
std::vector<float> fanfare() {
    Waveform wave(2.2);
    wave.add_note(kG4, 0.12, 0.8, 0.0)
        .add_note(kG4, 0.12, 0.8, 0.15)
        .add_note(kG4, 0.12, 0.8, 0.30);
    wave.add_note(kC5, 0.30, 1.0, 0.45)
        .add_note(kG4, 0.20, 0.6, 0.75)
        .add_note(kE5, 0.25, 0.9, 0.75);
    for (const double note_Hz : {kC5, kE5, kG5, kC6}) {
        wave.add_note(note_Hz, 0.40, 0.75, 1.05);
    }
    return wave.finish(0.6);
}

std::vector<float> pop() {
    return Waveform(0.14).add(Glide{330.0, 820.0, 0.025, 0.028, 1.0}, 0.0, 0.004).finish(0.4);
}

std::vector<float> click() {
    return Waveform(0.06)
        .add(Mode{1250.0, 0.007, 1.0}, 0.0, 0.0008)
        .add(Mode{2100.0, 0.004, 0.4}, 0.0, 0.0008)
        .finish(0.3);
}

struct Recipe {
    std::string_view name;
    std::vector<float> (*make)();
};

constexpr std::array<Recipe, 13> kRecipes{{{"catch", caught},
                                           {"catch_watermelon", caught_watermelon},
                                           {"catch_apple", caught_apple},
                                           {"catch_banana", caught_banana},
                                           {"catch_egg", caught_egg},
                                           {"landed", landed},
                                           {"splat", splat},
                                           {"right", right},
                                           {"try_again", try_again},
                                           {"level_up", level_up},
                                           {"finish", fanfare},
                                           {"pop", pop},
                                           {"click", click}}};

// A lesson may ask for exactly these.
static_assert(std::equal(kRecipes.begin(), kRecipes.end(), kSoundNames.begin(), kSoundNames.end(),
                         [](const Recipe& recipe, std::string_view name) {
                             return recipe.name == name;
                         }));

}  // namespace

std::span<const std::string_view> sound_names() {
    return kSoundNames;
}

Expected<std::vector<float>> synthesise(std::string_view name) {
    for (const Recipe& recipe : kRecipes) {
        if (recipe.name == name) {
            return recipe.make();
        }
    }
    std::string known;
    for (const std::string_view each : kSoundNames) {
        known += (known.empty() ? "" : ", ") + std::string(each);
    }
    return fail("there is no sound named " + std::string(name.substr(0, 40)), {},
                "use one of " + known);
}

std::vector<float> synthesise_force_loop() {
    // Whole numbers of periods in a second: the end meets the beginning.
    constexpr double kBase_Hz = 110.0;
    constexpr std::array<double, 4> kPartials{1.0, 0.5, 0.25, 0.08};
    std::vector<float> loop(kSampleRate_Hz);
    for (std::size_t i = 0; i < loop.size(); ++i) {
        double sum = 0.0;
        for (std::size_t k = 0; k < kPartials.size(); ++k) {
            const double turns = kBase_Hz * static_cast<double>((k + 1) * i) / kSampleRate_Hz;
            sum += kPartials[k] * std::sin(2.0 * std::numbers::pi * turns);
        }
        loop[i] = static_cast<float>(0.35 * sum);
    }
    return loop;
}

}  // namespace fulcrum::runtime
