#include "runtime/audio/resample.h"
#include "runtime/audio/sound_bank.h"
#include "runtime/audio/synthesis.h"
#include "runtime/audio/wav.h"
#include "tests/unit/runtime/rig.h"

#include <complex>
#include <numbers>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

std::string little(std::uint32_t value, int n) {
    std::string bytes;
    for (int i = 0; i < n; ++i) {
        bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
    }
    return bytes;
}

std::string chunk(const std::string& name, const std::string& bytes) {
    return name + little(static_cast<std::uint32_t>(bytes.size()), 4) + bytes +
           (bytes.size() % 2 == 1 ? std::string(1, '\0') : "");
}

std::string format(std::uint32_t kind, std::uint32_t channels, std::uint32_t rate_Hz,
                   std::uint32_t bits) {
    return chunk("fmt ", little(kind, 2) + little(channels, 2) + little(rate_Hz, 4) +
                             little(rate_Hz * channels * bits / 8, 4) +
                             little(channels * bits / 8, 2) + little(bits, 2));
}

std::string wav(const std::string& chunks) {
    return "RIFF" + little(static_cast<std::uint32_t>(4 + chunks.size()), 4) + "WAVE" + chunks;
}

std::string refusal(const std::string& bytes) {
    const auto sound = read_wav(bytes);
    return sound ? "" : to_sentence(sound.error());
}

std::vector<float> make_tone(double frequency_Hz, int rate_Hz, double duration_s) {
    std::vector<float> x(static_cast<std::size_t>(duration_s * rate_Hz));
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = static_cast<float>(
            std::sin(2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / rate_Hz));
    }
    return x;
}

// What is left of a sound without the tone of its own frequency, over the middle half: root mean square, and the tone's height.
std::pair<double, double> part_tone(const std::vector<float>& x, double frequency_Hz, int rate_Hz) {
    const std::size_t first = x.size() / 4;
    const std::size_t n = x.size() / 2;
    // Least squares over whole and broken waves alike: sine and cosine.
    double ss = 0.0, sc = 0.0, cc = 0.0, xs = 0.0, xc = 0.0;
    const auto angle = [&](std::size_t i) {
        return 2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / rate_Hz;
    };
    for (std::size_t i = first; i < first + n; ++i) {
        const double s = std::sin(angle(i)), c = std::cos(angle(i));
        ss += s * s, sc += s * c, cc += c * c;
        xs += static_cast<double>(x[i]) * s, xc += static_cast<double>(x[i]) * c;
    }
    const double det = ss * cc - sc * sc;
    const double a = (xs * cc - xc * sc) / det, b = (xc * ss - xs * sc) / det;
    double rest = 0.0;
    for (std::size_t i = first; i < first + n; ++i) {
        const double left =
            static_cast<double>(x[i]) - a * std::sin(angle(i)) - b * std::cos(angle(i));
        rest += left * left;
    }
    return {std::sqrt(rest / static_cast<double>(n)), std::hypot(a, b)};
}

}  // namespace

TEST_CASE("wav: a written file has the header and the samples that were given") {
    const auto path = std::filesystem::temp_directory_path() /
                      ("fulcrum_wav_test_" + std::to_string(::getpid()) + ".wav");
    const std::array<float, 4> samples{0.0F, 0.5F, -1.0F, 3.0F};
    REQUIRE(write_wav(path, samples, 2, 48'000));
    std::ifstream in(path, std::ios::binary);
    const std::string file((std::istreambuf_iterator<char>(in)), {});
    std::filesystem::remove(path);
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned>(static_cast<unsigned char>(file[i]));
    };
    const auto sample = [&](std::size_t i) {
        return static_cast<std::int16_t>(byte(44 + 2 * i) | byte(45 + 2 * i) << 8);
    };
    REQUIRE(file.size() == 44 + 8);
    CHECK(file.substr(0, 4) == "RIFF");
    CHECK((byte(24) | byte(25) << 8) == 48'000);
    CHECK(byte(22) == 2);
    CHECK((byte(28) | byte(29) << 8 | byte(30) << 16) == 48'000 * 4);  // bytes a second
    CHECK(byte(32) == 4);                                              // bytes a frame
    CHECK(byte(40) == 8);
    CHECK(sample(0) == 0);
    CHECK(sample(1) == 16384);
    CHECK(sample(2) == -32767);
    CHECK(sample(3) == 32767);
    CHECK_FALSE(write_wav("/no/such/folder/x.wav", samples, 2, 48'000));
    CHECK_FALSE(write_wav(path, samples, 3, 48'000));
}

TEST_CASE("wav: every kind of sample is read alike") {
    const std::vector<float> expected{0.5F, -0.5F, 0.0F, -1.0F};
    const auto all = [](std::initializer_list<std::uint32_t> samples, int n) {
        std::string bytes;
        for (const std::uint32_t sample : samples) {
            bytes += little(sample, n);
        }
        return chunk("data", bytes);
    };
    const std::vector<std::string> files{
        format(1, 1, 16000, 8) + all({192, 64, 128, 0}, 1),
        format(1, 1, 16000, 16) + all({0x4000, 0xC000, 0, 0x8000}, 2),
        format(1, 1, 16000, 24) + all({0x400000, 0xC00000, 0, 0x800000}, 3),
        format(1, 1, 16000, 32) + all({0x40000000, 0xC0000000, 0, 0x80000000}, 4),
        format(3, 1, 16000, 32) + all({0x3F000000, 0xBF000000, 0, 0xBF800000}, 4),
    };
    for (const std::string& file : files) {
        const auto sound = read_wav(wav(file));
        REQUIRE(sound);
        CHECK(sound->rate_Hz == 16000);
        CHECK(sound->samples == expected);
    }
    // Beyond all bounds, yet numbers.
    const auto loud = read_wav(wav(format(3, 1, 8000, 32) + all({0xFF7FFFFF, 0x7F7FFFFF}, 4)));
    REQUIRE(loud);
    CHECK(loud->samples == std::vector<float>{-1.0F, 1.0F});
}

TEST_CASE("wav: a sample that is no number, or infinite, is refused with its place") {
    // 0.5 in each but the last of so many; the last frame's last channel is odd.
    const auto refused = [](std::uint32_t odd, std::uint32_t channels, int frames) {
        std::string samples;
        for (int i = 1; i < frames * static_cast<int>(channels); ++i) {
            samples += little(0x3F000000, 4);
        }
        return refusal(
            wav(format(3, channels, 8000, 32) + chunk("data", samples + little(odd, 4))));
    };
    CHECK(refused(0x3F000000, 1, 5).empty());
    for (const std::uint32_t odd : {0x7FC00000U, 0xFFC00001U, 0x7F800001U}) {
        CHECK(refused(odd, 1, 5).find("its sample 5, at 0.001 s, is no number") !=
              std::string::npos);
    }
    for (const std::uint32_t odd : {0x7F800000U, 0xFF800000U}) {
        CHECK(refused(odd, 1, 1).find("its sample 1, at 0.000 s, is infinite") !=
              std::string::npos);
        CHECK(refused(odd, 2, 8001).find("its sample 8001, at 1.000 s, is infinite") !=
              std::string::npos);
    }
    CHECK(refused(0x7FC00000, 1, 5).find("save it as WAV") != std::string::npos);
    // The same bits are numbers where they are no floats.
    CHECK(refusal(wav(format(1, 1, 8000, 32) + chunk("data", little(0x7FC00000, 4)))).empty());
}

TEST_CASE("wav: channels are averaged, other chunks passed over, an open length is to the end") {
    const std::string samples =
        little(0x4000, 2) + little(0, 2) + little(0xC000, 2) + little(0xC000, 2);
    const auto stereo =
        read_wav(wav(chunk("LIST", "odd") + format(1, 2, 44100, 16) + chunk("data", samples)));
    REQUIRE(stereo);
    CHECK(stereo->samples == std::vector<float>{0.25F, -0.5F});
    const auto piped =
        read_wav(wav(format(1, 1, 22050, 16)) + "data" + little(0x7FFFF000, 4) + samples);
    REQUIRE(piped);
    CHECK(piped->samples == std::vector<float>{0.5F, 0.0F, -0.5F, -0.5F});
    CHECK(read_wav(wav(format(1, 1, 22050, 16) + chunk("data", "")))->samples.empty());
}

TEST_CASE("wav: what cannot be heard is refused in one sentence") {
    const std::string good = wav(format(1, 1, 16000, 16) + chunk("data", std::string(8, '\0')));
    REQUIRE(refusal(good).empty());
    CHECK(refusal("").find("it does not begin as one") != std::string::npos);
    CHECK(refusal("RIFF\x10\0\0\0WAXE").find("it does not begin as one") != std::string::npos);
    CHECK(refusal(wav(chunk("data", "abcd"))).find("samples before a format") != std::string::npos);
    CHECK(refusal(wav(format(1, 1, 16000, 16))).find("no samples") != std::string::npos);
    CHECK(refusal(wav(format(2, 1, 16000, 4))).find("another kind (2, 4 bits)") !=
          std::string::npos);
    CHECK(refusal(wav(format(1, 9, 16000, 16))).find("9 channels") != std::string::npos);
    CHECK(refusal(wav(format(1, 1, 3999, 16))).find("at 3999 Hz") != std::string::npos);
    CHECK(refusal(wav(chunk("fmt ", "short"))).find("cut short") != std::string::npos);
    // Wherever it is cut off, it is refused, or what is there is heard.
    for (std::size_t n = 0; n < good.size(); ++n) {
        CHECK_FALSE(refusal(good.substr(0, n)).empty());
    }
}

TEST_CASE("resample: a tone stays that tone, as high, and nothing else is heard") {
    for (const auto& [from_Hz, to_Hz] :
         {std::pair(16000, 48000), {22050, 48000}, {48000, 16000}, {44100, 48000}, {8000, 48000}}) {
        const double half_Hz = 0.5 * std::min(from_Hz, to_Hz);
        for (const double share : {0.01, 0.2, 0.5, 0.8}) {
            const double frequency_Hz = share * half_Hz;
            const auto y = resample(make_tone(frequency_Hz, from_Hz, 0.2), from_Hz, to_Hz);
            CAPTURE(from_Hz, to_Hz, frequency_Hz);
            CHECK(y.size() == static_cast<std::size_t>(std::lround(0.2 * to_Hz)));
            const auto [rest, height] = part_tone(y, frequency_Hz, to_Hz);
            CHECK(height == Approx(1.0).margin(1.0e-3));
            CHECK(rest < 3.0e-4);  // 70 dB
        }
    }
}

TEST_CASE("resample: what the lower rate cannot hold is left out, not folded back") {
    const auto y = resample(make_tone(9500.0, 48000, 0.2), 48000, 16000);
    double most = 0.0;
    for (std::size_t i = y.size() / 4; i < 3 * y.size() / 4; ++i) {
        most = std::max(most, std::abs(static_cast<double>(y[i])));
    }
    CHECK(most < 1.0e-3);
}

TEST_CASE("resample: the same rate gives the same samples; nothing gives nothing") {
    const auto x = make_tone(440.0, 16000, 0.01);
    CHECK(resample(x, 16000, 16000) == x);
    CHECK(resample({}, 16000, 48000).empty());
    const std::array<float, 1> one{0.5F};
    CHECK(resample(one, 16000, 48000).size() == 3);
}

TEST_CASE("sound bank: no names means all, names mean these, each once") {
    const auto all = make_bank({});
    REQUIRE(all.has_value());
    CHECK(all->size() == sound_names().size());
    const auto some = make_bank({{"pop", "click", "pop"}, true, 1.0});
    REQUIRE(some.has_value());
    REQUIRE(some->size() == 2);
    for (const BankedSound& sound : *some) {
        CHECK(sound.samples == *synthesise(sound.name));
    }
}

TEST_CASE("sound bank: unknown names and loudness outside 0 to 1 are errors") {
    CHECK_FALSE(make_bank({{"moo"}, true, 1.0}));
    CHECK_FALSE(make_bank({{""}, true, 1.0}));
    for (const double gain : {-0.1, 1.1, std::nan("")}) {
        CHECK_FALSE(checked_names({{}, true, gain}));
    }
    const auto moo = make_bank({{"moo"}, true, 1.0});
    CHECK(moo.error().message.find("moo") != std::string::npos);
}

TEST_CASE("sound bank: gain and pitch are checked to their ends") {
    CHECK(check_play(0.0, 0.25));
    CHECK(check_play(1.0, 4.0));
    for (const auto& [gain, pitch] : {std::pair(-0.01, 1.0),
                                      {1.01, 1.0},
                                      {1.0, 0.24},
                                      {1.0, 4.01},
                                      {std::nan(""), 1.0},
                                      {1.0, std::nan("")}}) {
        CAPTURE(gain, pitch);
        CHECK_FALSE(check_play(gain, pitch));
    }
}
