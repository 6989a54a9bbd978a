// The pictures of one lesson as reliefs: each file is read once for each width on the surface, made no finer than a hand
// can tell, and all together no more than the program prepares in seconds.
//
//   a pixel is at least kFinestPixel_m wide: two samples of the shortest wave that a held stylus passes on (texture_settings.h)
//   a smaller picture is the mean of the larger one over each new pixel's area
//
// Thread: load path. Cost: some 10 ns a pixel of the file.
#pragma once

#include "haptics/base/error.h"
#include "haptics/surface/texture_settings.h"
#include "runtime/scene/picture/grey_picture.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace fulcrum::runtime {

inline constexpr double kFinestPixel_m = 5.0e-5;      ///< in the hand's metres
inline constexpr std::size_t kMaxFeltSide_px = 2048;  ///< of a relief
inline constexpr std::size_t kMaxFeltPixels =
    8'388'608;  ///< of all reliefs of a lesson: two of the largest

/// A picture ready to be a texture. Two that are equal share their heights.
struct FeltPicture {
    std::shared_ptr<const HeightMap> heights;
    double height_per_width =
        1.0;  ///< of the file, which the relief's own numbers only come near to
};

/// The same picture on width x height pixels, each 1 to as many as there are: the mean over each new pixel's area.
[[nodiscard]] GreyPicture shrink(const GreyPicture& picture, std::size_t width, std::size_t height);

class FeltPictures {
  public:
    /// `scale`: the scene's metres for one of the hand.
    FeltPictures(std::filesystem::path folder, double scale)
        : folder_(std::move(folder)), finest_pixel_m_(kFinestPixel_m * scale) {}

    /// `file` lies in the folder; `width_m` is the whole picture's on the surface, above 0. An error names the file.
    [[nodiscard]] Expected<FeltPicture> load(const std::string& file, double width_m);

  private:
    std::filesystem::path folder_;
    double finest_pixel_m_;
    std::map<std::pair<std::string, std::size_t>, FeltPicture>
        loaded_;  // by file and most pixels in a row
    std::size_t n_pixels_ = 0;
};

}  // namespace fulcrum::runtime
