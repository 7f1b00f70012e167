#include "ContactSheet.h"

#include "Typeface.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace lodsmith::cli {

namespace {

struct Colour {
    std::uint8_t red, green, blue;
};

constexpr Colour kPaper{255, 255, 255};
constexpr Colour kInk{32, 33, 36};
constexpr Colour kPaleInk{95, 99, 104};
constexpr Colour kRule{218, 220, 224};
constexpr Colour kWall{128, 128, 128}; // what the figures see behind the mesh
constexpr int kEdge = 24;              // around the sheet
constexpr int kGap = 24;               // between columns and between rows
constexpr int kPictureGap = 8;
constexpr int kFigureGap = 16;
constexpr int kLongest = 32767;

struct Size {
    int width = 0;
    int height = 0;
};

/// Puts things on an opaque picture. What sticks out is cut off.
class Canvas {
public:
    explicit Canvas(Size size)
        : mImage(Image::empty(static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)))
    {
        fill(0, 0, size, kPaper);
    }

    void fill(int left, int top, Size size, Colour colour)
    {
        for (int y = top; y < top + size.height; ++y)
            for (int x = left; x < left + size.width; ++x)
                if (std::uint8_t* const pixel = at(x, y))
                    set(pixel, colour);
    }

    void text(Typeface& typeface, const std::string& words, int left, int top, Colour colour)
    {
        typeface.draw(words, left, top, [&](int x, int y, std::uint8_t cover) {
            if (std::uint8_t* const pixel = at(x, y)) {
                const Colour before{pixel[0], pixel[1], pixel[2]};
                set(pixel, {mixed(before.red, colour.red, cover), mixed(before.green, colour.green, cover),
                            mixed(before.blue, colour.blue, cover)});
            }
        });
    }

    /// A picture before a wall, each of its pixels a square.
    void picture(const Image& image, unsigned scale, int left, int top)
    {
        const int side = static_cast<int>(scale);
        for (std::uint32_t y = 0; y < image.height; ++y)
            for (std::uint32_t x = 0; x < image.width; ++x) {
                const std::uint8_t* const pixel = image.pixel(x, y);
                const auto seen = [&](int channel) {
                    return static_cast<std::uint8_t>(pixel[channel] + (kWall.red * (255 - pixel[3]) + 127) / 255);
                };
                fill(left + static_cast<int>(x) * side, top + static_cast<int>(y) * side, {side, side},
                     {seen(0), seen(1), seen(2)});
            }
    }

    Image take() { return std::move(mImage); }

private:
    std::uint8_t* at(int x, int y)
    {
        const bool isInside =
            x >= 0 && y >= 0 && x < static_cast<int>(mImage.width) && y < static_cast<int>(mImage.height);
        return isInside ? mImage.pixel(static_cast<std::size_t>(x), static_cast<std::size_t>(y)) : nullptr;
    }

    static void set(std::uint8_t* pixel, Colour colour)
    {
        pixel[0] = colour.red;
        pixel[1] = colour.green;
        pixel[2] = colour.blue;
        pixel[3] = 255;
    }

    static std::uint8_t mixed(int before, int after, int cover)
    {
        return static_cast<std::uint8_t>((before * (255 - cover) + after * cover + 127) / 255);
    }

    Image mImage;
};

/// Knows how large everything is, and draws it.
class Layout {
public:
    Layout(const Sheet& sheet, Typeface& title, Typeface& heading, Typeface& body)
        : mSheet(sheet), mTitle(title), mHeading(heading), mBody(body), mColumns(sheet.columns.size())
    {
        for (std::size_t column = 0; column < mColumns.size(); ++column)
            mColumns[column] = mHeading.width(sheet.columns[column]);
        for (const SheetRow& row : sheet.rows) {
            mLabel = std::max(mLabel, sizeOfLabel(row).width);
            int height = sizeOfLabel(row).height;
            for (std::size_t column = 0; column < row.cells.size(); ++column) {
                const Size size = sizeOf(row.cells[column]);
                mColumns[column] = std::max(mColumns[column], size.width);
                height = std::max(height, size.height);
            }
            mRows.push_back(height);
        }
    }

    Size size() const
    {
        Size size{mLabel, headHeight() + mHeading.lineHeight()};
        for (const int width : mColumns)
            size.width += kGap + width;
        for (const int height : mRows)
            size.height += 2 * kGap + height;
        int head = mTitle.width(mSheet.title);
        for (const std::string& note : mSheet.notes)
            head = std::max(head, mBody.width(note));
        return {std::max(size.width, head) + 2 * kEdge, size.height + 2 * kEdge};
    }

    Image draw() const
    {
        Canvas canvas(size());
        canvas.text(mTitle, mSheet.title, kEdge, kEdge, kInk);
        for (std::size_t i = 0; i < mSheet.notes.size(); ++i)
            canvas.text(mBody, mSheet.notes[i], kEdge,
                        kEdge + mTitle.lineHeight() + static_cast<int>(i) * mBody.lineHeight(), kPaleInk);
        int top = kEdge + headHeight();
        for (std::size_t column = 0; column < mColumns.size(); ++column)
            canvas.text(mHeading, mSheet.columns[column], leftOf(column), top, kInk);
        top += mHeading.lineHeight();
        for (std::size_t row = 0; row < mRows.size(); ++row) {
            canvas.fill(kEdge, top + kGap / 2, {size().width - 2 * kEdge, 1}, kRule);
            drawRow(canvas, mSheet.rows[row], top + kGap);
            top += 2 * kGap + mRows[row];
        }
        return canvas.take();
    }

private:
    int headHeight() const
    {
        return mTitle.lineHeight() + static_cast<int>(mSheet.notes.size()) * mBody.lineHeight() + kGap;
    }

    int leftOf(std::size_t column) const
    {
        return kEdge + mLabel + kGap
               + std::accumulate(mColumns.begin(), mColumns.begin() + static_cast<std::ptrdiff_t>(column),
                                 static_cast<int>(column) * kGap);
    }

    std::array<int, 3> figureColumns(const SheetRow& row) const
    {
        std::array<int, 3> widths = {0, 0, 0};
        for (const auto& figure : row.figures)
            for (std::size_t i = 0; i < widths.size(); ++i)
                widths[i] = std::max(widths[i], mBody.width(figure[i]));
        return widths;
    }

    Size sizeOfLabel(const SheetRow& row) const
    {
        const std::array<int, 3> widths = figureColumns(row);
        int width = std::max(mHeading.width(row.heading), widths[0] + widths[1] + widths[2] + 2 * kFigureGap);
        for (const std::string& line : row.lines)
            width = std::max(width, mBody.width(line));
        const auto lines = static_cast<int>(row.lines.size() + row.figures.size());
        return {width, mHeading.lineHeight() + kPictureGap + lines * mBody.lineHeight()};
    }

    Size sizeOf(const SheetPicture& picture) const
    {
        return {std::max(static_cast<int>(picture.image.width * picture.scale), mBody.width(picture.caption)),
                static_cast<int>(picture.image.height * picture.scale) + mBody.lineHeight()};
    }

    Size sizeOf(const std::vector<SheetPicture>& line) const
    {
        Size size{-kPictureGap, 0};
        for (const SheetPicture& picture : line) {
            size.width += kPictureGap + sizeOf(picture).width;
            size.height = std::max(size.height, sizeOf(picture).height);
        }
        return size;
    }

    Size sizeOf(const SheetCell& cell) const
    {
        Size size;
        for (const auto& line : cell) {
            size.width = std::max(size.width, sizeOf(line).width);
            size.height += sizeOf(line).height + kPictureGap;
        }
        return size;
    }

    void drawRow(Canvas& canvas, const SheetRow& row, int top) const
    {
        drawLabel(canvas, row, top);
        for (std::size_t column = 0; column < row.cells.size(); ++column) {
            int y = top;
            for (const auto& line : row.cells[column]) {
                drawLine(canvas, line, leftOf(column), y);
                y += sizeOf(line).height + kPictureGap;
            }
        }
    }

    void drawLabel(Canvas& canvas, const SheetRow& row, int top) const
    {
        canvas.text(mHeading, row.heading, kEdge, top, kInk);
        top += mHeading.lineHeight() + kPictureGap;
        for (const std::string& line : row.lines) {
            canvas.text(mBody, line, kEdge, top, kInk);
            top += mBody.lineHeight();
        }
        const std::array<int, 3> widths = figureColumns(row);
        for (const auto& figure : row.figures) {
            canvas.text(mBody, figure[0], kEdge, top, kPaleInk);
            int right = kEdge + widths[0];
            for (std::size_t i = 1; i < figure.size(); ++i) {
                right += kFigureGap + widths[i];
                canvas.text(mBody, figure[i], right - mBody.width(figure[i]), top, kInk);
            }
            top += mBody.lineHeight();
        }
    }

    void drawLine(Canvas& canvas, const std::vector<SheetPicture>& line, int left, int top) const
    {
        for (const SheetPicture& picture : line) {
            canvas.picture(picture.image, picture.scale, left, top);
            canvas.text(mBody, picture.caption, left, top + static_cast<int>(picture.image.height * picture.scale),
                        kPaleInk);
            left += sizeOf(picture).width + kPictureGap;
        }
    }

    const Sheet& mSheet;
    Typeface& mTitle;
    Typeface& mHeading;
    Typeface& mBody;
    int mLabel = 0;            ///< width
    std::vector<int> mColumns; ///< widths
    std::vector<int> mRows;    ///< heights
};

} // namespace

Result<Image> drawSheet(const Sheet& sheet)
{
    const auto title = Typeface::load(LODSMITH_FONT_DIR "/DejaVuSans-Bold.ttf", 24);
    const auto heading = Typeface::load(LODSMITH_FONT_DIR "/DejaVuSans-Bold.ttf", 15);
    const auto body = Typeface::load(LODSMITH_FONT_DIR "/DejaVuSans.ttf", 13);
    for (const auto* typeface : {&title, &heading, &body})
        if (!*typeface)
            return typeface->error();
    const Layout layout(sheet, *title.value(), *heading.value(), *body.value());
    if (std::max(layout.size().width, layout.size().height) > kLongest)
        return Error{ErrorCode::InvalidSetting, "the pictures are too large for one sheet"};
    return layout.draw();
}

} // namespace lodsmith::cli
