#include "runtime/audio/wav.h"

#include <catch2/catch.hpp>

#include <array>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

using namespace fulcrum;
using namespace fulcrum::runtime;

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
