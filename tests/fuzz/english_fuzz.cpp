// A text from anyone is checked: its errors lie in order within it, and what lies between them is kept.
#include "dialogue/checking/checker.h"
#include "tests/fuzz/promise.h"

#include <memory>

using namespace fulcrum::dialogue;

namespace {

/// Finds most sentences wrong, and more so those of more bytes, so that whatever is proposed is tried.
class AnyJudge final : public SentenceJudge {
  public:
    std::optional<int> misfits(std::string_view sentence) override {
        return static_cast<int>(sentence.size() % 3);
    }
};

EnglishChecker make_checker() {
    auto lexicon = Lexicon::open();
    require(lexicon.has_value());
    return {std::move(*lexicon), std::make_unique<AnyJudge>()};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static EnglishChecker checker = make_checker();
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const CheckedText checked = checker.check(text);
    std::size_t at = 0;
    std::size_t kept = 0;
    std::size_t written = 0;
    for (const FreeError& error : checked.errors) {
        require(error.code != ErrorCode::none);
        require(at <= error.begin && error.begin <= error.end && error.end <= size);
        require(error.said == text.substr(error.begin, error.end - error.begin));
        kept += error.begin - at;
        written += error.right.size();
        at = error.end;
    }
    require(checked.corrected.size() == kept + written + (size - at));
    require(checked.corrected.ends_with(text.substr(at)));
    return 0;
}
