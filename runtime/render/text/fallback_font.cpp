#include "runtime/render/text/fallback_font.h"

#include <algorithm>
#include <fontconfig/fontconfig.h>
#include <memory>

namespace fulcrum::runtime {

namespace {

template <class T, void (*destroy)(T*)>
struct Destroyer {
    void operator()(T* thing) const { destroy(thing); }
};
using Pattern = std::unique_ptr<FcPattern, Destroyer<FcPattern, FcPatternDestroy>>;
using Characters = std::unique_ptr<FcCharSet, Destroyer<FcCharSet, FcCharSetDestroy>>;

// What the library knows of the system's fonts, from the first question to the program's end: it keeps it by offsets, so that a search for
// leaks would take it for one.
struct Library {
    Library() : is_there(FcInit() == FcTrue) {}
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    ~Library() { FcFini(); }
    bool is_there;
};

}  // namespace

std::optional<FontFile> find_font_with(std::u32string_view characters, bool bold) {
    static const Library library;
    if (!library.is_there) {
        return std::nullopt;
    }
    const Characters wanted(FcCharSetCreate());
    for (const char32_t c : characters) {
        FcCharSetAddChar(wanted.get(), c);
    }
    // Plain letters of one shape, that FreeType and HarfBuzz read alike.
    const Pattern asked(FcPatternCreate());
    FcPatternAddString(asked.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
    FcPatternAddCharSet(asked.get(), FC_CHARSET, wanted.get());
    FcPatternAddInteger(asked.get(), FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
    FcPatternAddBool(asked.get(), FC_OUTLINE, FcTrue);
    FcPatternAddBool(asked.get(), FC_COLOR, FcFalse);
    FcPatternAddBool(asked.get(), FC_VARIABLE, FcFalse);
    FcConfigSubstitute(nullptr, asked.get(), FcMatchPattern);
    FcDefaultSubstitute(asked.get());

    FcResult result = FcResultNoMatch;
    const Pattern found(FcFontMatch(nullptr, asked.get(), &result));
    FcCharSet* has = nullptr;
    FcChar8* path = nullptr;
    FontFile file;
    if (found == nullptr ||
        FcPatternGetCharSet(found.get(), FC_CHARSET, 0, &has) != FcResultMatch ||
        FcPatternGetString(found.get(), FC_FILE, 0, &path) != FcResultMatch ||
        !std::all_of(characters.begin(), characters.end(),
                     [&](char32_t c) { return FcCharSetHasChar(has, c) == FcTrue; })) {
        return std::nullopt;
    }
    (void)FcPatternGetInteger(found.get(), FC_INDEX, 0, &file.index);
    file.path = reinterpret_cast<const char*>(path);
    return file;
}

}  // namespace fulcrum::runtime
