// A model that has been loaded and checked: triangles and pictures, ready to be drawn or touched.
// The renderer and the collision code read this; neither knows the file format it came from.
//
//   Units: metres, +Y up, right-handed. All nodes are already flattened into model space: there is
//   no hierarchy left. A triangle's corners stand counter-clockwise as seen from outside.
//
// Thread: plain data; one writer while it loads, any number of readers after.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Triangles that share one material. With `n` corners: `positions` and `normals` hold 3n floats,
/// `uvs` 2n. What `load_gltf` hands out keeps to these sizes, every index is below n, and every
/// number is finite.
struct ModelPrimitive {
    std::vector<float> positions;  ///< x y z of each corner, metres (n x 3)
    std::vector<float> normals;    ///< x y z of each corner, unit length (n x 3)
    std::vector<float>
        uvs;  ///< u v of each corner, v downwards as in glTF; zeros where the file has none (n x 2)
    std::vector<std::uint32_t> indices;  ///< three a triangle, each below n
    std::array<float, 4> base_colour{1.0F, 1.0F, 1.0F,
                                     1.0F};  ///< linear r g b a, multiplies the picture, 0 to 1
    int image = -1;                          ///< index into LoadedModel::images, -1 for none
    float roughness = 0.6F;                  ///< 0 mirror-like to 1 matt
};

/// A picture: rows from the top, 8 bits a channel, sRGB colours with straight alpha.
struct ModelImage {
    int width = 0;                   ///< pixels
    int height = 0;                  ///< pixels
    std::vector<std::uint8_t> rgba;  ///< 4 bytes a pixel (height x width x 4)
};

/// A whole model.
struct LoadedModel {
    std::string name;                        ///< file name without its ending
    std::vector<ModelPrimitive> primitives;  ///< at least one
    std::vector<ModelImage> images;          ///< may be empty
};

}  // namespace fulcrum::runtime
