#include "runtime/scene/gltf/container.h"

#include "runtime/scene/gltf/limits.h"

#include <cstdint>
#include <cstring>

namespace fulcrum::runtime::gltf {
namespace {

constexpr std::size_t kHeader_bytes = 12;
constexpr std::size_t kChunkHeader_bytes = 8;
constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN"

std::uint32_t read_u32(std::span<const std::byte> file, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= std::to_integer<std::uint32_t>(file[at + i]) << (8 * i);
    }
    return value;
}

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Reads one chunk at `at` and moves `at` behind it.
Expected<std::span<const std::byte>> next_chunk(std::span<const std::byte> file, std::size_t& at,
                                                std::uint32_t& type) {
    if (file.size() - at < kChunkHeader_bytes) {
        return fail("the file ends inside a chunk header", {}, kExportAgain);
    }
    const std::size_t length = read_u32(file, at);
    type = read_u32(file, at + 4);
    at += kChunkHeader_bytes;
    if (length % 4 != 0 || length > file.size() - at) {
        return fail("a chunk reaches past the end of the file", {}, kExportAgain);
    }
    const auto chunk = file.subspan(at, length);
    at += length;
    return chunk;
}

}  // namespace

Expected<Container> split_container(std::span<const std::byte> file) {
    if (file.empty()) {
        return fail("the file is empty", {}, kExportAgain);
    }
    if (file.size() > kMaxFile_bytes) {
        return fail("the file is larger than 64 MiB", {}, kReduce);
    }
    if (file.size() < 4 || read_u32(file, 0) != kMagic) {
        return Container{as_text(file), {}};
    }

    // A GLB: header, JSON chunk, then at most one binary chunk; chunks of other kinds may follow.
    if (file.size() < kHeader_bytes + kChunkHeader_bytes) {
        return fail("the file ends inside its header", {}, kExportAgain);
    }
    if (read_u32(file, 4) != 2) {
        return fail("the file is not glTF version 2", {}, kExportAgain);
    }
    if (read_u32(file, 8) != file.size()) {
        return fail("the file is not as long as its header says", {}, "copy the file again");
    }
    Container container;
    std::size_t at = kHeader_bytes;
    std::uint32_t type = 0;
    auto chunk = next_chunk(file, at, type);
    if (!chunk) {
        return tl::unexpected(chunk.error());
    }
    if (type != kJsonChunk) {
        return fail("the first chunk is not JSON", {}, kExportAgain);
    }
    container.json = as_text(*chunk);
    for (bool first = true; at < file.size(); first = false) {
        chunk = next_chunk(file, at, type);
        if (!chunk) {
            return tl::unexpected(chunk.error());
        }
        if (first && type == kBinChunk) {
            container.binary = *chunk;
        }
    }
    return container;
}

}  // namespace fulcrum::runtime::gltf
