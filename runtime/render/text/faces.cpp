#include "runtime/render/text/faces.h"

#include "runtime/render/text/fallback_font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include <algorithm>
#include <hb.h>

namespace fulcrum::runtime {

namespace {

constexpr const char* kSpareFolder = "/usr/share/fonts/truetype/dejavu";
// A text full of characters that no font has does not keep fontconfig asking for each.
constexpr int kMostInVain = 64;
constexpr std::size_t kMostKnown = 20'000;  // letters of two styles: some megabytes

}  // namespace

Faces::Faces(const std::filesystem::path& folder) {
    if (FT_Init_FreeType(&library_) != 0) {
        library_ = nullptr;
        notice_ = "the library that draws letters did not start; install libfreetype6 again.";
        return;
    }
    const bool regular = open(Face::regular, folder / "Andika-Regular.ttf", 0);
    open(Face::bold, folder / "Andika-Bold.ttf", 0);
    const std::filesystem::path spare(kSpareFolder);
    const bool spare_regular = open(Face::regular, spare / "DejaVuSans.ttf", 0);
    open(Face::bold, spare / "DejaVuSans-Bold.ttf", 0);
    if (!regular) {
        notice_ = folder.string() + ": the font Andika is not there, so " +
                  (spare_regular ? "DejaVu Sans is used" : "no words can be drawn") +
                  "; install the package fonts-sil-andika.";
    }
}

Faces::~Faces() {
    for (const OpenFace& face : all_) {
        hb_font_destroy(face.shaper);
        FT_Done_Face(face.outlines);
    }
    if (library_ != nullptr) {
        FT_Done_FreeType(library_);
    }
}

bool Faces::open(Face style, const std::string& file, int index) {
    OpenFace face;
    if (all_.size() >= kNoFace || FT_New_Face(library_, file.c_str(), index, &face.outlines) != 0) {
        return false;
    }
    if (!FT_IS_SCALABLE(face.outlines) || face.outlines->units_per_EM == 0 ||
        FT_Select_Charmap(face.outlines, FT_ENCODING_UNICODE) != 0) {
        FT_Done_Face(face.outlines);
        return false;
    }
    face.units_per_em = static_cast<float>(face.outlines->units_per_EM);
    hb_blob_t* bytes = hb_blob_create_from_file(file.c_str());
    hb_face_t* shaped = hb_face_create(bytes, static_cast<unsigned>(index));
    face.shaper = hb_font_create(shaped);
    hb_face_destroy(shaped);
    hb_blob_destroy(bytes);
    by_style_[static_cast<std::size_t>(style)].push_back(all_.size());
    all_.push_back(face);
    return true;
}

std::vector<std::size_t>& Faces::list(Face style) {
    auto& bold = by_style_[static_cast<std::size_t>(Face::bold)];
    return style == Face::bold && !bold.empty()
               ? bold
               : by_style_[static_cast<std::size_t>(Face::regular)];
}

const OpenFace* Faces::usual() const {
    const auto& regular = by_style_[static_cast<std::size_t>(Face::regular)];
    return regular.empty() ? nullptr : &all_[regular.front()];
}

std::size_t Faces::first_with(Face style, std::u32string_view characters) {
    for (const std::size_t face : list(style)) {
        if (std::all_of(characters.begin(), characters.end(), [&](char32_t c) {
                return is_joiner(c) || FT_Get_Char_Index(all_[face].outlines, c) != 0;
            })) {
            return face;
        }
    }
    return kNoFace;
}

std::size_t Faces::face_of(Face style, std::u32string_view letter) {
    auto& known = known_[static_cast<std::size_t>(style)];
    const std::u32string key(letter);
    if (const auto place = known.find(key); place != known.end()) {
        return place->second;
    }
    std::size_t face = first_with(style, letter);
    if (face == kNoFace && library_ != nullptr && asked_in_vain_ < kMostInVain) {
        std::u32string drawn(letter);
        drawn.erase(std::remove_if(drawn.begin(), drawn.end(), is_joiner), drawn.end());
        const auto file = find_font_with(drawn, style == Face::bold);
        if (file && open(&list(style) == &by_style_[1] ? Face::bold : Face::regular, file->path,
                         file->index)) {
            face = first_with(style, letter);
        }
        asked_in_vain_ += face == kNoFace ? 1 : 0;
    }
    if (face == kNoFace) {
        face = first_with(style, letter.substr(0, 1));
    }
    if (known.size() >= kMostKnown) {
        known.clear();
    }
    known[key] = face;
    return face;
}

}  // namespace fulcrum::runtime
