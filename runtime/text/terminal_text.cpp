#include "runtime/text/terminal_text.h"

#include "dialogue/unicode.h"
#include "runtime/text/utf8.h"

namespace fulcrum::runtime {

std::string fit_to_columns(std::string_view utf8, int columns) {
    std::string fitting;
    int taken = 0;
    for (const char32_t decoded : decode_for_display(utf8)) {
        const char32_t c = decoded == U'\n' ? U' ' : decoded;
        taken += dialogue::columns_of(c);
        if (taken > columns) {
            break;
        }
        dialogue::append_utf8(fitting, c);
    }
    return fitting;
}

}  // namespace fulcrum::runtime
