#include "runtime/render/image.h"

#include "haptics/base/crc32.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <span>
#include <string_view>

namespace fulcrum::runtime {

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Sends bits as DEFLATE packs them: least significant first.
class BitWriter {
  public:
    explicit BitWriter(Bytes& out) : out_(out) {}
    void put(std::uint32_t bits, unsigned count) {
        held_ |= static_cast<std::uint64_t>(bits) << held_count_;
        held_count_ += count;
        while (held_count_ >= 8) {
            out_.push_back(static_cast<std::uint8_t>(held_ & 255U));
            held_ >>= 8U;
            held_count_ -= 8;
        }
    }
    /// Huffman codes are packed from their most significant bit.
    void put_code(std::uint32_t code, unsigned count) {
        std::uint32_t reversed = 0;
        for (unsigned i = 0; i < count; ++i) {
            reversed |= ((code >> i) & 1U) << (count - 1 - i);
        }
        put(reversed, count);
    }
    void finish() { put(0, (8 - held_count_) % 8); }

  private:
    Bytes& out_;
    std::uint64_t held_ = 0;
    unsigned held_count_ = 0;
};

/// RFC 1951, 3.2.6: the fixed code of a literal or length symbol, 0 to 287.
void put_symbol(BitWriter& writer, std::uint32_t symbol) {
    if (symbol < 144) {
        writer.put_code(0x30U + symbol, 8);
    } else if (symbol < 256) {
        writer.put_code(0x190U + symbol - 144U, 9);
    } else if (symbol < 280) {
        writer.put_code(symbol - 256U, 7);
    } else {
        writer.put_code(0xC0U + symbol - 280U, 8);
    }
}

// RFC 1951, 3.2.5: least length and distance of each symbol, and how many extra bits follow.
constexpr std::array<std::uint16_t, 29> kLengthStart{3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                                     15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                                     67, 83, 99, 115, 131, 163, 195, 227, 258};
constexpr std::array<std::uint8_t, 29> kLengthBits{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                                   2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
constexpr std::array<std::uint16_t, 30> kDistanceStart{
    1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
    193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
constexpr std::array<std::uint8_t, 30> kDistanceBits{0, 0, 0,  0,  1,  1,  2,  2,  3,  3,
                                                     4, 4, 5,  5,  6,  6,  7,  7,  8,  8,
                                                     9, 9, 10, 10, 11, 11, 12, 12, 13, 13};

template <std::size_t N>
std::size_t symbol_of(const std::array<std::uint16_t, N>& starts, std::size_t value) {
    const auto after = std::upper_bound(starts.begin(), starts.end(), value);
    return static_cast<std::size_t>(after - starts.begin()) - 1;
}

void put_match(BitWriter& writer, std::size_t length, std::size_t distance) {
    const std::size_t l = symbol_of(kLengthStart, length);
    put_symbol(writer, static_cast<std::uint32_t>(257 + l));
    writer.put(static_cast<std::uint32_t>(length - kLengthStart[l]), kLengthBits[l]);
    const std::size_t d = symbol_of(kDistanceStart, distance);
    writer.put_code(static_cast<std::uint32_t>(d), 5);
    writer.put(static_cast<std::uint32_t>(distance - kDistanceStart[d]), kDistanceBits[d]);
}

constexpr std::size_t kShortestMatch = 3;
constexpr std::size_t kLongestMatch = 258;
constexpr std::size_t kWindow = 32768;
constexpr std::size_t kHashSize = 1U << 15U;

/// One block with fixed codes; a match is looked for where the last three equal bytes stood.
void deflate(const Bytes& data, Bytes& out) {
    BitWriter writer(out);
    writer.put(1, 1);  // last block
    writer.put(1, 2);  // fixed codes
    std::vector<std::size_t> last_place(kHashSize, SIZE_MAX);
    const auto hash = [&](std::size_t i) {
        const std::uint32_t three = data[i] | (static_cast<std::uint32_t>(data[i + 1]) << 8U) |
                                    (static_cast<std::uint32_t>(data[i + 2]) << 16U);
        return (three * 2654435761U) >> 17U;
    };
    for (std::size_t i = 0; i < data.size();) {
        std::size_t length = 0;
        std::size_t distance = 0;
        if (i + kShortestMatch <= data.size()) {
            std::size_t& place = last_place[hash(i)];
            if (place != SIZE_MAX && i - place <= kWindow) {
                const std::size_t most = std::min(kLongestMatch, data.size() - i);
                while (length < most && data[place + length] == data[i + length]) {
                    ++length;
                }
                distance = i - place;
            }
            place = i;
        }
        if (length >= kShortestMatch) {
            put_match(writer, length, distance);
            i += length;
        } else {
            put_symbol(writer, data[i]);
            ++i;
        }
    }
    put_symbol(writer, 256);
    writer.finish();
}

void put_big_endian(Bytes& out, std::uint32_t value) {
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        out.push_back(static_cast<std::uint8_t>((value >> shift) & 255U));
    }
}

/// Adler-32 of RFC 1950.
std::uint32_t adler32(const Bytes& data) {
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::uint8_t byte : data) {
        a = (a + byte) % 65521U;
        b = (b + a) % 65521U;
    }
    return (b << 16U) | a;
}

void put_chunk(Bytes& out, std::string_view type, const Bytes& content) {
    put_big_endian(out, static_cast<std::uint32_t>(content.size()));
    const std::size_t start = out.size();
    out.insert(out.end(), type.begin(), type.end());
    out.insert(out.end(), content.begin(), content.end());
    put_big_endian(out, compute_crc32(std::as_bytes(std::span(out).subspan(start))));
}

/// Each row as the difference to its upper neighbour or its left one, whichever is smaller.
Bytes filtered_rows(const Image& image) {
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(image.width);
    Bytes out;
    out.reserve((row_bytes + 1) * static_cast<std::size_t>(image.height));
    Bytes left(row_bytes);
    Bytes up(row_bytes);
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
        const std::uint8_t* here = image.rgba.data() + row * row_bytes;
        long left_sum = 0;
        long up_sum = 0;
        for (std::size_t i = 0; i < row_bytes; ++i) {
            const std::uint8_t before = i >= 4 ? here[i - 4] : std::uint8_t{0};
            const std::uint8_t above = row > 0 ? *(here + i - row_bytes) : std::uint8_t{0};
            left[i] = static_cast<std::uint8_t>(here[i] - before);
            up[i] = static_cast<std::uint8_t>(here[i] - above);
            left_sum += std::abs(static_cast<std::int8_t>(left[i]));
            up_sum += std::abs(static_cast<std::int8_t>(up[i]));
        }
        const bool use_up = up_sum <= left_sum;
        out.push_back(use_up ? 2 : 1);
        const Bytes& chosen = use_up ? up : left;
        out.insert(out.end(), chosen.begin(), chosen.end());
    }
    return out;
}

}  // namespace

Expected<Bytes> encode_png(const Image& image) {
    if (image.width < 1 || image.height < 1 ||
        image.rgba.size() !=
            4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
        return fail("the picture has no pixels or a wrong number of them", {}, "draw it again");
    }
    Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    Bytes header;
    put_big_endian(header, static_cast<std::uint32_t>(image.width));
    put_big_endian(header, static_cast<std::uint32_t>(image.height));
    header.insert(header.end(), {8, 6, 0, 0, 0});  // 8 bits, RGBA, no interlace
    put_chunk(out, "IHDR", header);
    put_chunk(out, "sRGB", {0});  // perceptual

    const Bytes rows = filtered_rows(image);
    Bytes packed{0x78, 0x01};  // zlib: 32 KiB window, fastest
    deflate(rows, packed);
    put_big_endian(packed, adler32(rows));
    put_chunk(out, "IDAT", packed);
    put_chunk(out, "IEND", {});
    return out;
}

Expected<void> save_png(const std::filesystem::path& path, const Image& image) {
    const auto bytes = encode_png(image);
    if (!bytes) {
        return tl::make_unexpected(bytes.error());
    }
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes->data()),
               static_cast<std::streamsize>(bytes->size()));
    file.close();
    if (!file) {
        return fail("the picture cannot be written", path.string(),
                    "choose a folder that you may write to");
    }
    return {};
}

}  // namespace fulcrum::runtime
