// Any bytes at all as a picture to be felt: read or refused, never a crash, a leak or a number out of range.
#include "runtime/scene/picture/grey_picture.h"
#include "tests/fuzz/promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto picture = fulcrum::runtime::read_grey_picture(std::as_bytes(std::span(data, size)));
    if (!picture) {
        require(picture.error().message.rfind("the picture", 0) == 0);
        require(!picture.error().what_to_do.empty());
        return 0;
    }
    require(picture->width > 0 && picture->width <= fulcrum::runtime::kMaxGreySide_px);
    require(picture->height > 0 && picture->height <= fulcrum::runtime::kMaxGreySide_px);
    require(picture->values.size() == picture->width * picture->height);
    for (const float value : picture->values) {
        require(value >= 0.0F && value <= 1.0F);
    }
    return 0;
}
