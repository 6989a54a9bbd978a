// The load path of texture_stage.h.
#include "haptics/loop/texture_stage.h"

#include <algorithm>

namespace fulcrum {

bool TextureStage::is_needed(const HapticPlan& plan) noexcept {
    return std::ranges::any_of(plan.solids,
                               [](const SolidPlan& solid) { return solid.surface.texture.any(); });
}

TextureStage::TextureStage(const HapticPlan& plan) : heights_m_(plan.solids.size(), 0.0) {
    textures_.reserve(plan.solids.size());
    for (const SolidPlan& solid : plan.solids) {
        const TextureSettings& settings = solid.surface.texture;
        textures_.push_back(settings.any() ? std::make_unique<const Texture>(settings) : nullptr);
    }
}

std::size_t TextureStage::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(TextureStage) + textures_.capacity() * sizeof(textures_[0]) +
                        heights_m_.capacity() * sizeof(double);
    for (const auto& texture : textures_) {
        bytes += texture ? texture->memory_bytes() : 0;
    }
    return bytes;
}

}  // namespace fulcrum
