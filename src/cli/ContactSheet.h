#pragma once

#include <lodsmith/analysis/Image.h>
#include <lodsmith/core/Result.h>

#include <array>
#include <string>
#include <vector>

namespace lodsmith::cli {

struct SheetPicture {
    Image image;
    std::string caption;
    unsigned scale = 1; ///< pixels of the sheet along the side of one of the picture's
};

/// Pictures in lines, one line below the other.
using SheetCell = std::vector<std::vector<SheetPicture>>;

struct SheetRow {
    std::string heading;
    std::vector<std::string> lines;
    std::vector<std::array<std::string, 3>> figures; ///< a table: what, and two columns of numbers
    std::vector<SheetCell> cells;                    ///< for Sheet::columns, from the left
};

/// What a contact sheet shows. All texts are UTF-8.
struct Sheet {
    std::string title;
    std::vector<std::string> notes; ///< below the title
    std::vector<std::string> columns;
    std::vector<SheetRow> rows;
};

/// Lays it out and draws it; opaque, as large as it has to be. Errors: NotFound, BadFile (the typeface DejaVu Sans,
/// which it writes in); InvalidSetting when it would be longer than 32767 pixels in a direction.
Result<Image> drawSheet(const Sheet& sheet);

} // namespace lodsmith::cli
