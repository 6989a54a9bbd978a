#include "runtime/app/program_build.h"

#include <cstddef>
#include <cstring>
#include <elf.h>
#include <link.h>
#include <span>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kNoteAlignment = 4;

std::size_t rounded_up(std::size_t n) {
    return (n + kNoteAlignment - 1) / kNoteAlignment * kNoteAlignment;
}

std::string hex_of(std::span<const unsigned char> bytes) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : bytes) {
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 15U];
    }
    return text;
}

// The id among the notes of one segment; empty when it is not there.
std::string find_id(std::span<const unsigned char> notes) {
    constexpr char kOwner[] = "GNU";
    while (notes.size() >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) head{};
        std::memcpy(&head, notes.data(), sizeof head);
        const std::size_t name_at = sizeof head;
        const std::size_t id_at = name_at + rounded_up(head.n_namesz);
        const std::size_t end = id_at + rounded_up(head.n_descsz);
        if (end > notes.size()) {
            return {};
        }
        if (head.n_type == NT_GNU_BUILD_ID && head.n_namesz == sizeof kOwner &&
            std::memcmp(notes.data() + name_at, kOwner, sizeof kOwner) == 0) {
            return hex_of(notes.subspan(id_at, head.n_descsz));
        }
        notes = notes.subspan(end);
    }
    return {};
}

// The first object that is told is the program itself.
int look_at_program(dl_phdr_info* object, std::size_t /*size*/, void* found) {
    for (const ElfW(Phdr) & segment : std::span(object->dlpi_phdr, object->dlpi_phnum)) {
        if (segment.p_type != PT_NOTE) {
            continue;
        }
        const auto* begin =
            reinterpret_cast<const unsigned char*>(  // NOLINT(performance-no-int-to-ptr)
                object->dlpi_addr + segment.p_vaddr);
        if (auto id = find_id({begin, segment.p_memsz}); !id.empty()) {
            *static_cast<std::string*>(found) = std::move(id);
            break;
        }
    }
    return 1;
}

}  // namespace

std::string program_build_id() {
    std::string id;
    (void)dl_iterate_phdr(look_at_program, &id);
    return id.empty() ? "unknown" : id;
}

}  // namespace fulcrum::runtime
