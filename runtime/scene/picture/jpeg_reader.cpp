// JPEG, by libjpeg-turbo. Its errors come by longjmp: between setjmp and the last call that may jump there is nothing that
// has to be destroyed.
#include "runtime/scene/picture/samples.h"

#include <csetjmp>
#include <cstdio>
#include <utility>

// After <cstdio>: it needs FILE.
#include <jpeglib.h>

namespace fulcrum::runtime::picture {
namespace {

/// A progressive file has about ten; each goes over all pixels again.
constexpr int kMostScans = 64;
constexpr long kMostMemory_bytes = 256L << 20;

/// Everything that outlives a jump.
struct JpegJob {
    JpegJob() = default;
    JpegJob(const JpegJob&) = delete;
    JpegJob& operator=(const JpegJob&) = delete;
    ~JpegJob() {
        if (created) {
            jpeg_destroy_decompress(&jpeg);
        }
    }

    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf home{};
    bool created = false;
    Samples samples{};
};

JpegJob& job_of(j_common_ptr jpeg) {
    return *static_cast<JpegJob*>(jpeg->client_data);
}

[[noreturn]] void jump_back(j_common_ptr jpeg) {
    std::longjmp(job_of(jpeg).home, 1);  // NOLINT(cert-err52-cpp): libjpeg's way
}

/// A warning is a file that is cut off or garbled: what it would show is nobody's picture.
void refuse_warnings(j_common_ptr jpeg, int level) {
    if (level < 0) {
        jump_back(jpeg);
    }
}

void say_nothing(j_common_ptr /*jpeg*/) {}

void bound_scans(j_common_ptr jpeg) {
    if (job_of(jpeg).jpeg.input_scan_number > kMostScans) {
        jump_back(jpeg);
    }
}

bool read_header(JpegJob& job, const std::uint8_t* bytes, std::size_t n) {
    job.jpeg.err = jpeg_std_error(&job.errors);
    job.errors.error_exit = jump_back;
    job.errors.emit_message = refuse_warnings;
    job.errors.output_message = say_nothing;
    job.progress.progress_monitor = bound_scans;
    job.jpeg.client_data = &job;
    if (setjmp(job.home) != 0) {  // NOLINT(cert-err52-cpp): libjpeg's way
        return false;
    }
    jpeg_create_decompress(&job.jpeg);
    job.created = true;
    job.jpeg.progress = &job.progress;
    job.jpeg.mem->max_memory_to_use = kMostMemory_bytes;
    jpeg_mem_src(&job.jpeg, bytes, static_cast<unsigned long>(n));
    jpeg_read_header(&job.jpeg, TRUE);
    job.samples.width = job.jpeg.image_width;
    job.samples.height = job.jpeg.image_height;
    return true;
}

/// Four inks (CMYK) are for printers; libjpeg does not turn them into colours.
bool has_colours(const JpegJob& job) {
    return job.jpeg.jpeg_color_space == JCS_GRAYSCALE || job.jpeg.jpeg_color_space == JCS_RGB ||
           job.jpeg.jpeg_color_space == JCS_YCbCr;
}

bool read_rows(JpegJob& job, std::size_t row_bytes) {
    if (setjmp(job.home) != 0) {  // NOLINT(cert-err52-cpp): libjpeg's way
        return false;
    }
    job.jpeg.dct_method = JDCT_ISLOW;  // the same bits whatever the processor
    jpeg_start_decompress(&job.jpeg);
    while (job.jpeg.output_scanline < job.jpeg.output_height) {
        JSAMPROW row = job.samples.bytes.data() + job.jpeg.output_scanline * row_bytes;
        jpeg_read_scanlines(&job.jpeg, &row, 1);
    }
    jpeg_finish_decompress(&job.jpeg);
    return true;
}

}  // namespace

Expected<Samples> decode_jpeg(std::span<const std::uint8_t> file) {
    JpegJob job;
    if (!read_header(job, file.data(), file.size())) {
        return damaged_picture();
    }
    if (auto sides = check_sides(job.samples.width, job.samples.height); !sides) {
        return tl::unexpected(sides.error());
    }
    if (!has_colours(job)) {
        return fail("the picture is made of inks for a printer (CMYK)", {},
                    "save it anew in RGB, the colours of a screen");
    }
    job.samples.channels = job.jpeg.jpeg_color_space == JCS_GRAYSCALE ? 1 : 3;
    job.jpeg.out_color_space = job.samples.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
    const std::size_t row_bytes =
        job.samples.width * static_cast<std::size_t>(job.samples.channels);
    job.samples.bytes.resize(row_bytes * job.samples.height);
    if (!read_rows(job, row_bytes)) {
        return damaged_picture();
    }
    return std::move(job.samples);
}

}  // namespace fulcrum::runtime::picture
