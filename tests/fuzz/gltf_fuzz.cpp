// Any bytes at all as a model: loaded or refused, never a crash, a leak or a promise broken.
#include "runtime/scene/gltf/collision_from_model.h"
#include "runtime/scene/gltf/gltf_model.h"
#include "tests/fuzz/promise.h"

namespace {

void check_primitive(const fulcrum::runtime::ModelPrimitive& primitive, std::size_t n_images) {
    const std::size_t n = primitive.positions.size() / 3;
    require(primitive.positions.size() == 3 * n && primitive.normals.size() == 3 * n &&
            primitive.uvs.size() == 2 * n && primitive.indices.size() % 3 == 0);
    require(primitive.image < static_cast<int>(n_images));
    for (const std::uint32_t index : primitive.indices) {
        require(index < n);
    }
    for (const float x : primitive.positions) {
        require(std::isfinite(x));
    }
    for (const float x : primitive.uvs) {
        require(std::isfinite(x));
    }
    for (std::size_t i = 0; i < 3 * n; i += 3) {
        const float* normal = primitive.normals.data() + i;
        require(std::abs(std::hypot(normal[0], normal[1], normal[2]) - 1.0F) < 1e-4F);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto model =
        fulcrum::runtime::read_gltf(std::as_bytes(std::span(data, size)), "fuzz.glb");
    if (!model) {
        require(!model.error().message.empty() &&
                model.error().message.find('\n') == std::string::npos);
        return 0;
    }
    for (const auto& primitive : model->primitives) {
        check_primitive(primitive, model->images.size());
    }
    for (const auto& image : model->images) {
        require(image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                         static_cast<std::size_t>(image.height));
    }
    (void)fulcrum::runtime::collision_from_model(*model);
    return 0;
}
