// What a surface's fine relief is made of, and by which law it is felt. The laws stand in texture.h.
//
// A relief is a height h over the surface, metres, 0 (valley) to height_m (peak), periodic in two directions u and v. It is
// laid on a body by three projections along the body's own axes (triplanar.h): no mesh needs coordinates of its own.
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace fulcrum {

/// Heights on a grid, as an image has them: 0 is the lowest, 1 the highest. Rows follow each other, u runs along a row.
struct HeightMap {
    std::int32_t n_u = 0;        ///< in a row, 1 to 4096
    std::int32_t n_v = 0;        ///< rows, 1 to 4096
    std::vector<float> heights;  ///< n_u * n_v of them, each 0 to 1
};

/// An image, repeated for ever: the last column is followed by the first.
struct ImageTexture {
    std::shared_ptr<const HeightMap> map;
    double tile_u_m = 0.05;  ///< width of the whole image on the surface, 1e-4 to 100
    double tile_v_m = 0.05;  ///< its height on the surface, 1e-4 to 100
};

/// Grooves: h = height_m (1 + sin(2 pi s / wavelength)) / 2, s along `direction_rad` from the u axis.
struct SineTexture {
    double wavelength_m = 0.002;  ///< 1e-4 to 1
    double direction_rad = 0.0;   ///< across the grooves, -100 to 100
};

/// Random bumps whose wavelengths lie in a band: as many waves of every direction as fit into a tile, with phases by the
/// seed; the same seed gives the same bumps.
struct NoiseTexture {
    double shortest_m = 0.001;  ///< wavelength, 1e-4 to longest_m
    double longest_m = 0.004;   ///< wavelength, to 1 and to 64 times the shortest
    std::uint32_t seed = 1;
};

/// std::monostate: none.
using TextureSource = std::variant<std::monostate, ImageTexture, SineTexture, NoiseTexture>;

/// How a height is felt. See texture.h.
enum class TextureLaw : std::uint8_t {
    perturbed_normal,  ///< the surface's normal leans against the slope; as in the thesis
    lateral,           ///< a force along the surface against the slope (Minsky)
    height_offset,     ///< the surface is carved: its peaks lie where it was
};

/// Fixed at load.
struct TextureSettings {
    TextureSource source{};
    TextureLaw law = TextureLaw::perturbed_normal;
    /// From the deepest valley to the highest peak, 1e-7 to 0.01. Sharp edges of an image are rounded off by a curve that swings
    /// beyond them; that counts.
    double height_m = 1.0e-4;
    double gain = 1.0;  ///< K of each law, 0 to 100

    [[nodiscard]] bool any() const noexcept {
        return !std::holds_alternative<std::monostate>(source) && gain > 0.0;
    }
};

/// Refuses settings outside the ranges named at each field, NaN included, and a map whose size and heights disagree or
/// whose heights are not 0 to 1.
[[nodiscard]] Expected<void> validate(const TextureSettings& settings);

}  // namespace fulcrum
