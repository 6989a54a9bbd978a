// PNG, by libpng. Its errors come by longjmp: between setjmp and the last call that may jump there is nothing that has to
// be destroyed.
#include "runtime/scene/picture/samples.h"

#include <bit>
#include <csetjmp>
#include <cstring>
#include <png.h>
#include <utility>

namespace fulcrum::runtime::picture {
namespace {

constexpr png_uint_32 kMostChunks = 500;              // that are kept: texts, profiles
constexpr png_alloc_size_t kLargestChunk = 8U << 20;  // once inflated

/// Everything that outlives a jump.
struct PngJob {
    explicit PngJob(std::span<const std::uint8_t> bytes) : file(bytes) {}
    PngJob(const PngJob&) = delete;
    PngJob& operator=(const PngJob&) = delete;
    ~PngJob() { png_destroy_read_struct(&png, info != nullptr ? &info : nullptr, nullptr); }

    std::span<const std::uint8_t> file;
    png_structp png = nullptr;
    png_infop info = nullptr;
    Samples samples{};
    std::vector<png_bytep> rows;
};

void read_bytes(png_structp png, png_bytep to, std::size_t n) {
    auto& job = *static_cast<PngJob*>(png_get_io_ptr(png));
    if (n > job.file.size()) {
        png_error(png, "cut off");
    }
    std::memcpy(to, job.file.data(), n);
    job.file = job.file.subspan(n);
}

[[noreturn]] void jump_back(png_structp png, png_const_charp /*message*/) {
    png_longjmp(png, 1);
}

void say_nothing(png_structp /*png*/, png_const_charp /*message*/) {}

/// Grey or red, green and blue, 8 or 16 bits, without transparency; false when the file is damaged.
bool read_header(PngJob& job) {
    if (setjmp(png_jmpbuf(job.png)) != 0) {  // NOLINT(cert-err52-cpp): libpng's way
        return false;
    }
    png_set_user_limits(job.png, 0x7FFFFFFF, 0x7FFFFFFF);  // ours are told better, see check_sides
    png_set_chunk_cache_max(job.png, kMostChunks);
    png_set_chunk_malloc_max(job.png, kLargestChunk);
    png_set_read_fn(job.png, &job, read_bytes);
    png_read_info(job.png, job.info);
    job.samples.width = png_get_image_width(job.png, job.info);
    job.samples.height = png_get_image_height(job.png, job.info);
    return true;
}

/// What the rows will be like; false when the file is damaged.
bool prepare_rows(PngJob& job) {
    if (setjmp(png_jmpbuf(job.png)) != 0) {  // NOLINT(cert-err52-cpp): libpng's way
        return false;
    }
    png_set_expand(job.png);
    png_set_strip_alpha(job.png);
    if (std::endian::native == std::endian::little) {
        png_set_swap(job.png);
    }
    png_set_interlace_handling(job.png);
    png_read_update_info(job.png, job.info);
    job.samples.channels = png_get_channels(job.png, job.info);
    job.samples.bytes_a_channel = png_get_bit_depth(job.png, job.info) == 16 ? 2 : 1;
    return true;
}

bool read_rows(PngJob& job) {
    if (setjmp(png_jmpbuf(job.png)) != 0) {  // NOLINT(cert-err52-cpp): libpng's way
        return false;
    }
    png_read_image(job.png, job.rows.data());
    png_read_end(job.png, nullptr);
    return true;
}

}  // namespace

Expected<Samples> decode_png(std::span<const std::uint8_t> file) {
    PngJob job(file);
    job.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, jump_back, say_nothing);
    job.info = job.png != nullptr ? png_create_info_struct(job.png) : nullptr;
    if (job.info == nullptr) {
        return fail("the picture needs more memory than there is", {}, "make it smaller");
    }
    if (!read_header(job)) {
        return damaged_picture();
    }
    if (auto sides = check_sides(job.samples.width, job.samples.height); !sides) {
        return tl::unexpected(sides.error());
    }
    if (!prepare_rows(job)) {
        return damaged_picture();
    }
    const std::size_t row_bytes = png_get_rowbytes(job.png, job.info);
    const bool is_known = job.samples.channels == 1 || job.samples.channels == 3;
    if (!is_known ||
        row_bytes != job.samples.width * static_cast<std::size_t>(job.samples.channels *
                                                                  job.samples.bytes_a_channel)) {
        return damaged_picture();
    }
    job.samples.bytes.resize(row_bytes * job.samples.height);
    for (std::size_t y = 0; y < job.samples.height; ++y) {
        job.rows.push_back(job.samples.bytes.data() + y * row_bytes);
    }
    if (!read_rows(job)) {
        return damaged_picture();
    }
    return std::move(job.samples);
}

}  // namespace fulcrum::runtime::picture
