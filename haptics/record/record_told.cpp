// What loops were told, from and to bytes. See record.h.
#include "haptics/record/record_told.h"

namespace fulcrum {

template <class T>
void read_told(const RecordRounds& rounds, const RecordTold& told, T& value) {
    value = T{};
    record_layout::CheckedSource source(std::span(rounds.told_bytes).subspan(told.at, told.size));
    record_layout::visit_told(source, value);
}

template void read_told(const RecordRounds&, const RecordTold&, ForceCommand&);
template void read_told(const RecordRounds&, const RecordTold&, WorldFrame&);
template void read_told(const RecordRounds&, const RecordTold&, AxleOrders&);
template void read_told(const RecordRounds&, const RecordTold&, RigidFrame&);
template void read_told(const RecordRounds&, const RecordTold&, LineState&);
template void read_told(const RecordRounds&, const RecordTold&, ToldReading&);

namespace record_layout {
namespace {

template <class T>
bool is_whole(std::span<const std::byte> bytes) {
    T value{};
    CheckedSource source(bytes);
    visit_told(source, value);
    return source.is_whole();
}

constexpr std::size_t kToldHeadBytes = 16;  // tick, kind, size

bool is_told(RecordToldKind kind, std::span<const std::byte> bytes) {
    switch (kind) {
        case RecordToldKind::command:
            return is_whole<ForceCommand>(bytes);
        case RecordToldKind::world:
            return is_whole<WorldFrame>(bytes);
        case RecordToldKind::axles:
            return is_whole<AxleOrders>(bytes);
        case RecordToldKind::rigid:
            return is_whole<RigidFrame>(bytes);
        case RecordToldKind::line:
            return is_whole<LineState>(bytes);
        case RecordToldKind::reading:
            return is_whole<ToldReading>(bytes);
    }
    return false;
}

}  // namespace

bool take_told(Source& source, std::span<const std::byte> parts, std::size_t& at,
               RecordTold& told) {
    std::uint32_t kind = 0;
    std::uint32_t size = 0;
    if (!source.has(kToldHeadBytes)) {
        return false;
    }
    source.field(told.tick);
    source.field(kind);
    source.field(size);
    if (!source.has(size)) {
        return false;
    }
    source.skip(size);
    told.kind = static_cast<RecordToldKind>(kind);
    told.at += kToldHeadBytes;
    told.size = size;
    const bool is_whole = is_told(told.kind, parts.subspan(at + kToldHeadBytes, size));
    at += kToldHeadBytes + size;
    return is_whole;
}

}  // namespace record_layout
}  // namespace fulcrum
