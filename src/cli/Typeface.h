#pragma once

#include <lodsmith/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace lodsmith::cli {

/// A typeface of a font file, at one size, that draws text (FreeType).
class Typeface {
public:
    /// Errors: NotFound, BadFile; file is the path.
    /// @param height of the letters with their line, pixels
    static Result<std::unique_ptr<Typeface>> load(const std::filesystem::path& file, unsigned height);
    ~Typeface();
    Typeface(const Typeface&) = delete;
    Typeface& operator=(const Typeface&) = delete;

    /// Pixels from one line to the next.
    int lineHeight() const;
    /// Pixels that a text takes on its line. UTF-8; what is none, and what the font has no letter for, is its sign for
    /// such.
    int width(const std::string& text);
    /// How much of a pixel ink covers, 0..255; called for pixels with some, in no order.
    using Ink = std::function<void(int x, int y, std::uint8_t cover)>;
    /// @param left, top of the line
    void draw(const std::string& text, int left, int top, const Ink& ink);

private:
    struct Face;
    explicit Typeface(std::unique_ptr<Face> face);
    std::unique_ptr<Face> mFace;
};

} // namespace lodsmith::cli
