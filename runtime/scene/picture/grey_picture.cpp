#include "runtime/scene/picture/grey_picture.h"

#include "runtime/scene/gltf/model_files.h"
#include "runtime/scene/picture/kind.h"
#include "runtime/scene/picture/samples.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <string>

namespace fulcrum::runtime {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Channel `index` of all channels of all pixels, 0 to 1.
float sample(const picture::Samples& samples, std::size_t index) {
    if (samples.bytes_a_channel == 2) {
        std::uint16_t value = 0;
        std::memcpy(&value, samples.bytes.data() + 2 * index, 2);
        return static_cast<float>(value) / 65535.0F;
    }
    return static_cast<float>(samples.bytes[index]) / 255.0F;
}

GreyPicture make_grey(const picture::Samples& samples) {
    GreyPicture grey{samples.width, samples.height, {}};
    const std::size_t n = grey.width * grey.height;
    grey.values.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        if (samples.channels == 1) {
            grey.values.push_back(sample(samples, i));
            continue;
        }
        const float luma = 0.299F * sample(samples, 3 * i) + 0.587F * sample(samples, 3 * i + 1) +
                           0.114F * sample(samples, 3 * i + 2);
        grey.values.push_back(std::min(luma, 1.0F));
    }
    return grey;
}

Expected<picture::Samples> decode(Bytes file) {
    switch (picture::kind_of(file)) {
        case picture::Kind::png:
            return picture::decode_png(file);
        case picture::Kind::jpeg:
            return picture::decode_jpeg(file);
        case picture::Kind::neither:
            break;
    }
    return fail("the picture is neither PNG nor JPEG", {}, picture::kSaveAgain);
}

}  // namespace

Expected<void> picture::check_sides(std::size_t width, std::size_t height) {
    if (width == 0 || height == 0 || width > kMaxGreySide_px || height > kMaxGreySide_px) {
        return fail(
            "the picture has " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
            {}, "make it 1 to " + std::to_string(kMaxGreySide_px) + " pixels on each side");
    }
    return {};
}

Expected<GreyPicture> read_grey_picture(std::span<const std::byte> file) {
    if (file.size() > kMaxGreyFile_bytes) {
        return fail("the picture's file is too large", {}, "make the picture smaller");
    }
    try {
        return decode({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()})
            .map(make_grey);
    } catch (const std::bad_alloc&) {
        return fail("the picture needs more memory than there is", {}, "make it smaller");
    }
}

Expected<GreyPicture> load_grey_picture(const std::filesystem::path& path) {
    const auto bytes = gltf::read_regular_file(path, kMaxGreyFile_bytes, false);
    if (!bytes) {
        return fail(bytes.error().message, {}, "put a PNG or JPEG there");
    }
    return read_grey_picture(*bytes).map_error([&](const Error& error) {
        return Error{error.message, path.filename().string(), error.what_to_do};
    });
}

bool is_flat(const GreyPicture& picture) {
    constexpr float kHalfStep = 0.5F / 255.0F;
    const auto [low, high] = std::minmax_element(picture.values.begin(), picture.values.end());
    return picture.values.empty() || *high - *low < kHalfStep;
}

}  // namespace fulcrum::runtime
