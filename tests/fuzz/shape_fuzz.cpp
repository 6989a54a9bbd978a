// Any bytes at all as a kept shape: read or refused, never a crash, and what was read is whole: every question to it is answered
// and it writes the same bytes. The same bytes are tried again with their checksum put right, so that mutations reach what it guards.
#include "haptics/geometry/shape.h"
#include "haptics/levels/level_bytes.h"
#include "haptics/levels/level_pairs.h"
#include "haptics/voxel/distance_field_batch.h"
#include "haptics/voxel/shape_bytes.h"
#include "tests/fuzz/promise.h"

#include <cstring>

namespace {

using fulcrum::Bytes;
using fulcrum::Digest;
using fulcrum::Vector3;

constexpr std::size_t kKeyAt = 16;

template <class Shape>
bool accept(const fulcrum::Expected<Shape>& shape, const Bytes& bytes, const Digest& key) {
    if (!shape) {
        require(to_sentence(shape.error()).find('\n') == std::string::npos);
        return false;
    }
    require(encode(*shape, key) == bytes);
    return true;
}

// Inside, on its edges, outside and far away.
void ask(const fulcrum::DistanceField& field) {
    const Vector3 lower = field.frame().lower_O;
    const Vector3 size = field.frame().upper_O() - lower;
    std::array<std::array<float, fulcrum::kLeafPoints>, 6> leaf{};
    for (int i = 0; i < 32; ++i) {
        const Vector3 share(i % 4 / 2.0 - 0.25, i / 4 % 4 / 2.0 - 0.25, i / 16 - 0.1 * (i % 3));
        const Vector3 p = lower + share.cwiseProduct(size);
        require(std::abs(field.sample(p).value_m) <= 1.0001 * field.band_m());
        (void)field.bound_distance_m(p);
        (void)field.find_free_radius_m(p);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            leaf[axis][static_cast<std::size_t>(i)] =
                static_cast<float>(p[static_cast<fulcrum::Index>(axis)]);
        }
    }
    const fulcrum::ShellPoints points{leaf[0].data(), leaf[1].data(), leaf[2].data(),
                                      leaf[3].data(), leaf[4].data(), leaf[5].data()};
    (void)sum_contacts(fulcrum::best_field_kernels(), field, fulcrum::Pose{}, points,
                       fulcrum::kLeafPoints, fulcrum::ForceAlong::slopes);
}

// Two of them far apart, near each other, and in each other.
void ask(const std::shared_ptr<const fulcrum::ContactLevels>& levels) {
    fulcrum::LevelPairSettings settings;
    settings.tolerance_m = 0.01;
    settings.most_pairs = 256;
    settings.most_contacts = 64;
    const auto pairs = fulcrum::LevelPairs::create(levels, levels, settings);
    require(pairs.has_value());
    for (int i = 0; i < 4; ++i) {
        const double away_m = 0.7 * i * levels->size_m();
        (void)(*pairs)->find(fulcrum::Pose::at(Vector3(away_m, 0.1 * away_m, 0.0)),
                             levels->settings().within_m);
        require((*pairs)->contacts().size() <= 64);
    }
    (void)can_be_of(*levels, fulcrum::make_sphere(1.0, 1).value());
    require(levels->memory_bytes() > 0);
}

void try_bytes(const Bytes& bytes) {
    Digest key{};
    if (bytes.size() >= kKeyAt + sizeof key) {
        std::memcpy(key.data(), bytes.data() + kKeyAt, sizeof key);
    }
    const auto field = fulcrum::decode_distance_field(bytes, key);
    if (accept(field, bytes, key)) {
        ask(*field);
    }
    // Runs that could be one are written as one, so only what is inside is compared.
    if (const auto grid = fulcrum::decode_voxel_grid(bytes, key)) {
        const auto again = fulcrum::decode_voxel_grid(encode(*grid, key), key);
        require(again && again->cells == grid->cells);
        require(grid->find_class({0, 0, 0}) == grid->cells.front());
    }
    const auto solid = fulcrum::decode_measured_solid(bytes, key);
    if (accept(solid, bytes, key)) {
        require(solid->moments.volume_m3 > 0.0 && solid->moments.second_m5.allFinite());
    }
    const auto levels = fulcrum::decode_contact_levels(bytes, key);
    if (levels) {
        require(encode(**levels, key) == bytes);
        ask(*levels);
    } else {
        require(to_sentence(levels.error()).find('\n') == std::string::npos);
    }
    const auto shell = fulcrum::decode_pointshell(bytes, key);
    if (accept(shell, bytes, key)) {
        require(shell->position_T(shell->size() - 1).allFinite());
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto given = std::as_bytes(std::span(data, size));
    Bytes bytes(given.begin(), given.end());
    try_bytes(bytes);
    if (bytes.size() > sizeof(Digest)) {
        const std::size_t end = bytes.size() - sizeof(Digest);
        const Digest checksum = fulcrum::compute_sha256(std::span(bytes).first(end));
        std::memcpy(bytes.data() + end, checksum.data(), sizeof checksum);
        try_bytes(bytes);
    }
    return 0;
}
