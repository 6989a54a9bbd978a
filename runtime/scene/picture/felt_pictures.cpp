#include "runtime/scene/picture/felt_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace fulcrum::runtime {
namespace {

/// The mean over each of `n_out` equal parts of every row; what comes out has a column for each row of what went in.
std::vector<float> shrink_rows(const std::vector<float>& values, std::size_t n_in,
                               std::size_t n_out) {
    const std::size_t n_rows = values.size() / n_in;
    const double step = static_cast<double>(n_in) / static_cast<double>(n_out);
    std::vector<float> out(n_out * n_rows);
    for (std::size_t row = 0; row < n_rows; ++row) {
        const float* in = values.data() + row * n_in;
        for (std::size_t k = 0; k < n_out; ++k) {
            const double begin = static_cast<double>(k) * step;
            const double end = std::min(begin + step, static_cast<double>(n_in));
            double sum = 0.0;
            for (auto i = static_cast<std::size_t>(begin); static_cast<double>(i) < end; ++i) {
                const auto at = static_cast<double>(i);
                sum += (std::min(at + 1.0, end) - std::max(at, begin)) * static_cast<double>(in[i]);
            }
            out[k * n_rows + row] = static_cast<float>(std::clamp(sum / (end - begin), 0.0, 1.0));
        }
    }
    return out;
}

/// What is left of a side of `n` pixels.
std::size_t felt_side(std::size_t n, double factor) {
    return std::clamp<std::size_t>(
        static_cast<std::size_t>(std::ceil(static_cast<double>(n) * factor)), 1, n);
}

}  // namespace

GreyPicture shrink(const GreyPicture& picture, std::size_t width, std::size_t height) {
    const std::vector<float> turned = shrink_rows(picture.values, picture.width, width);
    return {width, height, shrink_rows(turned, picture.height, height)};
}

Expected<FeltPicture> FeltPictures::load(const std::string& file, double width_m) {
    const double wanted = std::ceil(width_m / finest_pixel_m_);
    const auto most =
        static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(kMaxFeltSide_px)));
    const auto known = loaded_.find({file, most});
    if (known != loaded_.end()) {
        return known->second;
    }
    auto picture = load_grey_picture(folder_ / file);
    if (!picture) {
        return tl::unexpected(picture.error());
    }
    const auto n_u = static_cast<double>(picture->width);
    const auto n_v = static_cast<double>(picture->height);
    const double factor = std::min({1.0, static_cast<double>(most) / n_u,
                                    static_cast<double>(kMaxFeltSide_px) / std::max(n_u, n_v)});
    const std::size_t width = felt_side(picture->width, factor);
    const std::size_t height = felt_side(picture->height, factor);
    n_pixels_ += width * height;
    if (n_pixels_ > kMaxFeltPixels) {
        return fail("the lesson's pictures are too large together", file,
                    "use fewer or smaller ones, or give them a smaller size");
    }
    if (width != picture->width || height != picture->height) {
        *picture = shrink(*picture, width, height);
    }
    auto heights = std::make_shared<HeightMap>();
    heights->n_u = static_cast<std::int32_t>(width);
    heights->n_v = static_cast<std::int32_t>(height);
    heights->heights = std::move(picture->values);
    return loaded_.emplace(std::pair{file, most}, FeltPicture{std::move(heights), n_v / n_u})
        .first->second;
}

}  // namespace fulcrum::runtime
