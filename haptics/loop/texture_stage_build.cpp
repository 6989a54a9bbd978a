// The load path of texture_stage.h.
#include "haptics/loop/texture_stage.h"

#include <algorithm>
#include <type_traits>
#include <variant>

namespace fulcrum {
namespace {

// Every field by its place, so that one that is added breaks the build here instead of being forgotten.
bool is_same(const std::monostate& /*a*/, const std::monostate& /*b*/) {
    return true;
}
bool is_same(const ImageTexture& a, const ImageTexture& b) {
    const auto& [map_a, u_a, v_a] = a;
    const auto& [map_b, u_b, v_b] = b;
    return map_a == map_b && u_a == u_b && v_a == v_b;
}
bool is_same(const SineTexture& a, const SineTexture& b) {
    const auto& [wavelength_a, direction_a] = a;
    const auto& [wavelength_b, direction_b] = b;
    return wavelength_a == wavelength_b && direction_a == direction_b;
}
bool is_same(const NoiseTexture& a, const NoiseTexture& b) {
    const auto& [shortest_a, longest_a, seed_a] = a;
    const auto& [shortest_b, longest_b, seed_b] = b;
    return shortest_a == shortest_b && longest_a == longest_b && seed_a == seed_b;
}

bool is_same(const TextureSettings& a, const TextureSettings& b) {
    const auto& [source_a, law_a, height_a, gain_a] = a;
    const auto& [source_b, law_b, height_b, gain_b] = b;
    const auto same_source = [&other_source = source_b](const auto& one) {
        const auto* other = std::get_if<std::remove_cvref_t<decltype(one)>>(&other_source);
        return other != nullptr && is_same(one, *other);
    };
    return law_a == law_b && height_a == height_b && gain_a == gain_b &&
           std::visit(same_source, source_a);
}

}  // namespace

bool TextureStage::is_needed(const HapticPlan& plan) noexcept {
    return std::ranges::any_of(plan.solids,
                               [](const SolidPlan& solid) { return solid.surface.texture.any(); });
}

TextureStage::TextureStage(const HapticPlan& plan) : heights_m_(plan.solids.size(), 0.0) {
    // Solids of one material share its texture: a photo's takes megabytes.
    textures_.resize(plan.solids.size());
    for (std::size_t i = 0; i < plan.solids.size(); ++i) {
        const TextureSettings& settings = plan.solids[i].surface.texture;
        if (!settings.any()) {
            continue;
        }
        for (std::size_t k = 0; k < i && !textures_[i]; ++k) {
            if (textures_[k] && is_same(plan.solids[k].surface.texture, settings)) {
                textures_[i] = textures_[k];
            }
        }
        if (!textures_[i]) {
            textures_[i] = std::make_shared<const Texture>(settings);
        }
    }
}

std::size_t TextureStage::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(TextureStage) + textures_.capacity() * sizeof(textures_[0]) +
                        heights_m_.capacity() * sizeof(double);
    for (auto at = textures_.begin(); at != textures_.end(); ++at) {
        const bool is_first = *at && std::find(textures_.begin(), at, *at) == at;
        bytes += is_first ? (*at)->memory_bytes() : 0;
    }
    return bytes;
}

}  // namespace fulcrum
