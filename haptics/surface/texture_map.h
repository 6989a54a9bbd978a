// A relief ready to be felt: a periodic height with a slope everywhere, in finer and coarser levels.
//
//   h(u, v) = sum over i, j of c_ij B(u/a - i) B(v/b - j)       B: the uniform cubic B-spline; a, b: distance of samples
// goes through all samples (c by the inverse of B on the grid) and has two continuous derivatives, so that a force made
// of its slope is continuous and bends nowhere. Level 0 has the samples as given, each next level half as many a side,
// low-passed before (Lanczos' kernel of three lobes), down to a single one. Sample i of n lies at u = i tile_u / n.
//
// Thread: made at load, then read from any. Cost: a sample about 15 ns; 5.4 bytes a height.
// Source: M. Unser, A. Aldroubi, M. Eden 1993, B-spline signal processing, Part I, IEEE Trans. Signal Processing 41(2):
// the recursive inverse filter with the pole sqrt(3) - 2; here with periodic borders.
#pragma once

#include "haptics/surface/texture_settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum {

/// Height in metres and its derivatives along u and v, pure numbers.
struct HeightSample {
    double height_m = 0.0;
    double slope_u = 0.0;
    double slope_v = 0.0;
};

class TextureMap {
  public:
    /// Takes a map and sizes that `validate` accepted; a height of 1 becomes `height_m`.
    TextureMap(const HeightMap& map, double tile_u_m, double tile_v_m, double height_m);

    /// The lowest and the highest of the finest level, at its samples and half-way between them. The spline's own are hardly
    /// beyond: by a hundredth of a step of the samples.
    struct Extremes {
        double low_m;
        double high_m;
    };
    [[nodiscard]] Extremes find_extremes() const;
    /// Makes every height h of all levels factor h + offset_m.
    void rescale(double factor, double offset_m);

    /// `level` below n_levels(). A place that is not finite has height and slopes 0.
    [[nodiscard]] HeightSample sample(std::size_t level, double u_m, double v_m) const noexcept;

    [[nodiscard]] std::size_t n_levels() const noexcept { return levels_.size(); }
    /// How many samples of a level a way along the surface passes.
    [[nodiscard]] double count_samples(std::size_t level, double u_m, double v_m) const noexcept;
    [[nodiscard]] std::int32_t n_u(std::size_t level) const noexcept { return levels_[level].n_u; }
    [[nodiscard]] std::int32_t n_v(std::size_t level) const noexcept { return levels_[level].n_v; }
    [[nodiscard]] double tile_u_m() const noexcept { return tile_u_m_; }
    [[nodiscard]] double tile_v_m() const noexcept { return tile_v_m_; }
    /// With everything on the heap.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    struct Level {
        std::int32_t n_u = 1;
        std::int32_t n_v = 1;
        double per_u = 1.0;  // samples a metre
        double per_v = 1.0;
        std::vector<float> c;  // row by row, metres
    };
    [[nodiscard]] static Level make_level(std::vector<double> heights_m, std::int32_t n_u,
                                          std::int32_t n_v);

    double tile_u_m_;
    double tile_v_m_;
    std::vector<Level> levels_;
};

/// A grid of n_out samples over the same period as the n_in that it is made of, low-passed where it is coarser. Both 1 or more.
[[nodiscard]] std::vector<double> resample_periodic(const std::vector<double>& samples,
                                                    std::size_t n_out);

/// The coefficients of the cubic B-spline that goes through the samples of one period.
[[nodiscard]] std::vector<double> compute_spline_coefficients(const std::vector<double>& samples);

}  // namespace fulcrum
