#include "dialogue/speech/sphinx/decoder.h"
#include "dialogue/speech/sphinx/noise_floor.h"
#include "dialogue/speech/sphinx/pronunciation.h"
#include "dialogue/speech/sphinx/quieten.h"
#include "dialogue/speech/sphinx/stretch.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/dialogue/rig.h"

#include <numbers>
#include <random>

using namespace fulcrum::dialogue;

// What the decoder hears stands in tests/unit/runtime/hearing, where there are voices.

namespace {

Decoder& shared_decoder() {
    static const std::unique_ptr<Decoder> kDecoder = Decoder::create({}).value();
    return *kDecoder;
}

WordGraph one_way(const std::vector<std::string>& words) {
    WordGraph graph;
    graph.words = words;
    graph.nodes = static_cast<int>(words.size()) + 1;
    for (int i = 0; i + 1 < graph.nodes; ++i) {
        graph.arcs.push_back({i, i + 1, i, 1.0});
    }
    return graph;
}

constexpr double kRate_Hz = 16'000.0;

// Two seconds of tones with pauses, over white noise so far below their root mean square; `share`: of the time that is tone.
std::vector<std::int16_t> sound(double noise_dB, double share) {
    constexpr double kLoud = 8000.0;
    const double voice_rms = kLoud / std::numbers::sqrt2 * std::sqrt(share);
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0.0, voice_rms * std::pow(10.0, -noise_dB / 20.0));
    std::vector<std::int16_t> samples;
    for (int i = 0; i < 32'000; ++i) {
        const double within = std::fmod(i / kRate_Hz, 0.5) / 0.5;
        const double tone =
            within < share ? kLoud * std::sin(2.0 * std::numbers::pi * 300.0 * i / kRate_Hz) : 0.0;
        samples.push_back(static_cast<std::int16_t>(std::lround(tone + noise(random))));
    }
    return samples;
}

std::optional<std::string> look_up(std::string_view word) {
    static const std::map<std::string, std::string, std::less<>> kWords{
        {"good", "G UH D"},      {"make", "M EY K"}, {"break", "B R EY K"},
        {"want", "W AA N T"},    {"man", "M AE N"},  {"box", "B AA K S"},
        {"foot", "F UH T"},      {"big", "B IH G"},  {"hard", "HH AA R D"},
        {"heavy", "HH EH V IY"}, {"play", "P L EY"}, {"heavier", "HH EH V IY ER"}};
    const auto found = kWords.find(word);
    return found == kWords.end() ? std::nullopt : std::optional(found->second);
}

std::string sounds(std::string_view word) {
    return pronounce(word, look_up).value_or("?");
}

std::vector<std::int16_t> made_of(std::size_t n, double tone, double noise) {
    std::mt19937 random(1);
    std::normal_distribution<double> room(0.0, 1.0);
    std::vector<std::int16_t> sound;
    for (std::size_t i = 0; i < n; ++i) {
        // A tone in the middle half, the room always.
        const bool speaks = i > n / 4 && i < 3 * n / 4;
        const double t = static_cast<double>(i) / kRate_Hz;
        const double x = (speaks ? tone * std::sin(2.0 * std::numbers::pi * 440.0 * t) : 0.0) +
                         noise * room(random);
        sound.push_back(static_cast<std::int16_t>(std::lround(x)));
    }
    return sound;
}

double power(const std::vector<std::int16_t>& sound, double from, double to) {
    double sum = 0.0;
    const auto n = static_cast<double>(sound.size());
    const auto first = static_cast<std::size_t>(from * n);
    const auto last = static_cast<std::size_t>(to * n);
    for (std::size_t i = first; i < last; ++i) {
        sum += static_cast<double>(sound[i]) * static_cast<double>(sound[i]);
    }
    return sum / static_cast<double>(last - first);
}

double tone_at(double n, double frequency_Hz) {
    return 10000.0 * std::sin(2.0 * std::numbers::pi * frequency_Hz * n / kRate_Hz);
}

std::vector<std::int16_t> tone(double frequency_Hz) {
    std::vector<std::int16_t> x(8000);
    for (std::size_t n = 0; n < x.size(); ++n) {
        x[n] =
            static_cast<std::int16_t>(std::lround(tone_at(static_cast<double>(n), frequency_Hz)));
    }
    return x;
}

}  // namespace

TEST_CASE("sphinx decoder: settings and models that are not there are refused in one sentence") {
    CHECK(validate(DecoderSettings{}));
    CHECK_FALSE(validate(DecoderSettings{.width = 0.0}));
    CHECK_FALSE(validate(DecoderSettings{.middle = std::numeric_limits<double>::quiet_NaN()}));
    CHECK_FALSE(validate(DecoderSettings{.width = std::numeric_limits<double>::infinity()}));
    CHECK_FALSE(validate(DecoderSettings{.throats = {}}));
    CHECK_FALSE(validate(DecoderSettings{.throats = {1.0, 0.5}}));
    CHECK_FALSE(validate(DecoderSettings{.throats = {std::numeric_limits<double>::quiet_NaN()}}));
    CHECK_FALSE(validate(DecoderSettings{.throats = std::vector<double>(17, 1.0)}));
    // A dictionary that is cut off: PocketSphinx itself would end the process.
    const fulcrum::ScratchFolder folder;
    std::filesystem::create_directories(folder.path() / "en-us");
    folder.write("en-us/mdef", "");
    folder.write("en-us-phone.lm.bin", "");
    folder.write("cmudict-en-us.dict", "egg EH G\nrock R A");
    const auto cut_off = Decoder::create({.models = folder.path().string()});
    REQUIRE_FALSE(cut_off);
    CHECK(cut_off.error().message.find("line 2 has \"A\"") != std::string::npos);
    const auto missing = Decoder::create({.models = "/no/such/folder"});
    REQUIRE_FALSE(missing);
    CHECK(missing.error().message.find("install the package pocketsphinx-en-us") !=
          std::string::npos);
}

TEST_CASE(
    "sphinx decoder: words that nobody knows are told, and a graph without a way is refused") {
    Decoder& decoder = shared_decoder();
    const auto all = decoder.listen(one_way({"the", "egg", "goodest"}));
    REQUIRE(all);
    CHECK(all->empty());
    WordGraph with_unknown = one_way({"the", "egg"});
    with_unknown.words.emplace_back("zyzzyvaq");
    with_unknown.arcs.push_back({0, 1, 2, 1.0});
    CHECK(decoder.listen(with_unknown).value() == std::vector<std::string>{"zyzzyvaq"});
    CHECK_FALSE(decoder.listen(one_way({"the", "zyzzyvaq"})));
    CHECK_FALSE(decoder.listen({}));
    for (const WordGraph::Arc& bad : {WordGraph::Arc{0, 5, 0, 1.0},
                                      {-1, 1, 0, 1.0},
                                      {0, 1, 9, 1.0},
                                      {0, 1, 0, 0.0},
                                      {0, 1, 0, 2.0}}) {
        WordGraph graph = one_way({"the", "egg"});
        graph.arcs.push_back(bad);
        CHECK_FALSE(decoder.listen(graph));
    }
}

TEST_CASE("sphinx decoder: silence, noise and nothing are not taken for an answer") {
    Decoder& decoder = shared_decoder();
    const std::vector<std::int16_t> silence(16000, 0);
    // Before anything is listened for.
    CHECK_FALSE(decoder.listen({}));
    CHECK(decoder.decode(silence).text.empty());
    REQUIRE(decoder.listen(one_way({"the", "watermelon", "is", "the", "heaviest"})));
    CHECK(decoder.decode({}).confidence == 0.0);
    CHECK(decoder.decode(silence).confidence < 0.4);
    std::vector<std::int16_t> noise(16000);
    std::uint32_t state = 1;
    for (std::int16_t& sample : noise) {
        state = state * 1664525U + 1013904223U;
        sample = static_cast<std::int16_t>(static_cast<int>(state >> 18U) - 8192);
    }
    CHECK(decoder.decode(noise).confidence < 0.4);
    CHECK(std::isfinite(decoder.decode(noise).difference));
}

TEST_CASE("room: noise of a known level is found within two decibels, however long the pauses") {
    for (const double share : {0.3, 0.6, 0.8}) {
        for (const double dB : {10.0, 20.0, 30.0, 40.0}) {
            CAPTURE(share, dB);
            // The quietest of some frames are a little below their mean.
            CHECK(room_below_voice_dB(sound(dB, share)) == Approx(dB).margin(2.0));
        }
    }
}

TEST_CASE(
    "room: silence between words is a silent room; noise alone, and nothing, have no voice above "
    "or no room below") {
    CHECK(room_below_voice_dB(sound(200.0, 0.5)) == kSilentRoom_dB);
    CHECK(room_below_voice_dB({}) == kSilentRoom_dB);
    CHECK(room_below_voice_dB(std::vector<std::int16_t>(100, 3000)) == kSilentRoom_dB);
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 1000.0);
    std::vector<std::int16_t> hiss;
    for (int i = 0; i < 32'000; ++i) {
        hiss.push_back(static_cast<std::int16_t>(std::lround(noise(random))));
    }
    CHECK(room_below_voice_dB(hiss) == 0.0);
    CHECK(room_below_voice_dB(std::vector<std::int16_t>(32'000, 32767)) == 0.0);
}

TEST_CASE("pronunciation: the dictionary's comes first") {
    CHECK(sounds("heavier") == "HH EH V IY ER");
    CHECK(sounds("make") == "M EY K");
}

TEST_CASE("pronunciation: what learners make by rule sounds as the rule says") {
    CHECK(sounds("goodest") == "G UH D AH S T");
    CHECK(sounds("gooder") == "G UH D ER");
    CHECK(sounds("maked") == "M EY K T");
    CHECK(sounds("wanted") == "W AA N T IH D");
    CHECK(sounds("played") == "P L EY D");
    CHECK(sounds("mans") == "M AE N Z");
    CHECK(sounds("foots") == "F UH T S");
    CHECK(sounds("boxs") == "B AA K S IH Z");
    CHECK(sounds("boxes") == "B AA K S IH Z");
    CHECK(sounds("man's") == "M AE N Z");
    CHECK(sounds("hardly") == "HH AA R D L IY");
    CHECK(sounds("hardness") == "HH AA R D N AH S");
    // The rules of spelling undone.
    CHECK(sounds("bigger") == "B IH G ER");
    CHECK(sounds("heaviest") == "HH EH V IY AH S T");
    CHECK(sounds("heaviness") == "HH EH V IY N AH S");
}

TEST_CASE("pronunciation: what nobody knows has none") {
    for (const char* word : {"", "s", "ed", "zyzzyva", "xs", "est", "er"}) {
        CHECK(sounds(word) == "?");
    }
}

TEST_CASE("quieten: what has no noise comes back, to the rounding") {
    const auto sound = made_of(16'000, 8000.0, 0.0);
    const auto same = quieten(sound);
    REQUIRE(same.size() == sound.size());
    for (std::size_t i = 0; i < sound.size(); ++i) {
        REQUIRE(std::abs(same[i] - sound[i]) <= 1);
    }
}

TEST_CASE("quieten: the room is lowered by 7 dB and more, and the voice is kept") {
    const auto sound = made_of(32'000, 8000.0, 560.0);  // 20 dB below the tone
    const auto quieter = quieten(sound);
    REQUIRE(quieter.size() == sound.size());
    CHECK(10.0 * std::log10(power(sound, 0.02, 0.22) / power(quieter, 0.02, 0.22)) > 7.0);
    // The tone has 32e6, and of the noise in it little is left.
    CHECK(std::abs(10.0 * std::log10(power(quieter, 0.3, 0.7) / 32.0e6)) < 0.2);
    // What is left is nearer to the tone than what was there.
    const auto clean = made_of(32'000, 8000.0, 0.0);
    const auto apart = [&](const std::vector<std::int16_t>& other) {
        double sum = 0.0;
        for (std::size_t i = 0; i < clean.size(); ++i) {
            sum += std::pow(static_cast<double>(other[i]) - static_cast<double>(clean[i]), 2);
        }
        return sum;
    };
    CHECK(apart(quieter) < 0.25 * apart(sound));
}

TEST_CASE("quieten: silence, what is short, the loudest and nothing at all") {
    CHECK(quieten({}).empty());
    for (const std::size_t n : {std::size_t{1}, std::size_t{511}, std::size_t{1279}}) {
        const auto sound = made_of(n, 8000.0, 100.0);
        CHECK(quieten(sound) == sound);
    }
    const std::vector<std::int16_t> silence(4000, 0);
    CHECK(quieten(silence) == silence);
    std::vector<std::int16_t> loudest(8000, std::numeric_limits<std::int16_t>::min());
    for (std::size_t i = 0; i < loudest.size(); i += 3) {
        loudest[i] = std::numeric_limits<std::int16_t>::max();
    }
    CHECK(quieten(loudest).size() == loudest.size());
}

TEST_CASE("stretch: a tone comes down by the factor, as loud as it was, and lasts longer by it") {
    for (const double factor : {1.1, 1.25, 1.5, 2.0}) {
        for (const double frequency_Hz : {300.0, 1000.0, 4000.0}) {
            CAPTURE(factor, frequency_Hz);
            const auto y = stretch(tone(frequency_Hz), factor);
            CHECK(y.size() == static_cast<std::size_t>(8000.0 * factor));
            double worst = 0.0;
            for (std::size_t n = 200; n + 200 < y.size(); ++n) {
                worst = std::max(
                    worst, std::abs(y[n] - tone_at(static_cast<double>(n), frequency_Hz / factor)));
            }
            CHECK(worst < 0.01 * 10000.0);  // 40 dB below it
        }
    }
}

TEST_CASE("stretch: by one nothing changes; a factor out of its range is the nearest in it") {
    const auto x = tone(700.0);
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    for (const double none : {1.0, 0.5, -3.0, kNaN}) {
        CHECK(stretch(x, none) == x);
    }
    CHECK(stretch(x, 100.0) == stretch(x, kMostStretch));
    CHECK(stretch({}, 1.5).empty());
}

TEST_CASE("stretch: the loudest sound stays in range, and what stands still stands still") {
    std::vector<std::int16_t> edge(400, std::numeric_limits<std::int16_t>::min());
    std::fill(edge.begin() + 200, edge.end(), std::numeric_limits<std::int16_t>::max());
    const auto y = stretch(edge, 1.3);
    CHECK(y[100] < -32000);
    CHECK(y[420] > 32000);
    CHECK(*std::ranges::max_element(y) == std::numeric_limits<std::int16_t>::max());
}
