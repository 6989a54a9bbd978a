#include "dialogue/marked_text.h"

#include <algorithm>

namespace fulcrum::dialogue {

MarkedText part_emphasis(std::string_view text) {
    MarkedText result;
    while (!text.empty()) {
        const std::size_t open = text.find('*');
        const std::size_t close = open == std::string_view::npos ? open : text.find('*', open + 1);
        if (close == std::string_view::npos) {
            result.plain += text;
            break;
        }
        result.plain += text.substr(0, open);
        const std::size_t begin = result.plain.size();
        result.plain += text.substr(open + 1, close - open - 1);
        if (result.plain.size() > begin) {
            result.strong.emplace_back(begin, result.plain.size());
        }
        text.remove_prefix(close + 1);
    }
    return result;
}

}  // namespace fulcrum::dialogue
