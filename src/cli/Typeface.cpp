#include "Typeface.h"

#include "../files/AtomicFile.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <utility>
#include <vector>

namespace lodsmith::cli {

namespace {

constexpr char32_t kUnknown = 0xFFFD;

/// How many bytes follow the first one of a character; -1 for a byte that begins none.
int followers(unsigned char first)
{
    if (first < 0x80)
        return 0;
    if (first >= 0xC2 && first < 0xE0)
        return 1;
    if (first >= 0xE0 && first < 0xF0)
        return 2;
    return first >= 0xF0 && first < 0xF5 ? 3 : -1;
}

std::vector<char32_t> characters(const std::string& text)
{
    std::vector<char32_t> result;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i++]);
        const int more = followers(first);
        char32_t character = more <= 0 ? first : first & (0x3Fu >> more);
        int read = 0;
        for (; read < more && i < text.size() && (text[i] & 0xC0) == 0x80; ++read)
            character = character << 6 | (static_cast<unsigned char>(text[i++]) & 0x3Fu);
        result.push_back(more < 0 || read < more ? kUnknown : character);
    }
    return result;
}

} // namespace

struct Typeface::Face {
    ~Face()
    {
        if (face)
            FT_Done_Face(face);
        if (library)
            FT_Done_FreeType(library);
    }

    /// Calls `work` with each letter's bitmap and where its line's origin is, in 64ths of a pixel. Returns where the
    /// text ends.
    template <class Work>
    FT_Pos lay(const std::string& text, int loading, Work work)
    {
        FT_Pos pen = 0;
        for (const char32_t character : characters(text)) {
            if (FT_Load_Char(face, character, loading) != 0)
                continue;
            work(*face->glyph, pen);
            pen += face->glyph->advance.x;
        }
        return pen;
    }

    std::string bytes;
    FT_Library library = nullptr;
    FT_Face face = nullptr;
};

Typeface::Typeface(std::unique_ptr<Face> face) : mFace(std::move(face)) {}

Typeface::~Typeface() = default;

Result<std::unique_ptr<Typeface>> Typeface::load(const std::filesystem::path& file, unsigned height)
{
    auto face = std::make_unique<Face>();
    Result<std::string> bytes = readFile(file);
    if (!bytes)
        return bytes.error();
    face->bytes = std::move(bytes).value();
    const auto* begin = reinterpret_cast<const FT_Byte*>(face->bytes.data());
    if (FT_Init_FreeType(&face->library) != 0
        || FT_New_Memory_Face(face->library, begin, static_cast<FT_Long>(face->bytes.size()), 0, &face->face) != 0
        || FT_Set_Pixel_Sizes(face->face, 0, height) != 0)
        return Error{ErrorCode::BadFile, "is no font that FreeType reads", file.string()};
    return std::unique_ptr<Typeface>(new Typeface(std::move(face)));
}

int Typeface::lineHeight() const
{
    return static_cast<int>(mFace->face->size->metrics.height >> 6);
}

int Typeface::width(const std::string& text)
{
    return static_cast<int>((mFace->lay(text, FT_LOAD_DEFAULT, [](const FT_GlyphSlotRec&, FT_Pos) {}) + 63) >> 6);
}

void Typeface::draw(const std::string& text, int left, int top, const Ink& ink)
{
    const int base = top + static_cast<int>(mFace->face->size->metrics.ascender >> 6);
    mFace->lay(text, FT_LOAD_RENDER, [&](const FT_GlyphSlotRec& glyph, FT_Pos pen) {
        const int x = left + static_cast<int>(pen >> 6) + glyph.bitmap_left, y = base - glyph.bitmap_top;
        for (unsigned row = 0; row < glyph.bitmap.rows; ++row)
            for (unsigned column = 0; column < glyph.bitmap.width; ++column) {
                const auto pitch = static_cast<std::ptrdiff_t>(glyph.bitmap.pitch);
                const std::uint8_t cover = glyph.bitmap.buffer[static_cast<std::ptrdiff_t>(row) * pitch + column];
                if (cover > 0)
                    ink(x + static_cast<int>(column), y + static_cast<int>(row), cover);
            }
    });
}

} // namespace lodsmith::cli
