#include "Table.h"

#include <gtest/gtest.h>

namespace lodsmith::cli {

TEST(Table, columnsAreAsWideAsTheirWidestCell)
{
    Table table({"a", "long heading", "b"});
    table.add({"1000", "2", "3"});
    table.add({"4"});
    EXPECT_EQ(table.text(), "   a  long heading  b\n"
                            "1000             2  3\n"
                            "   4\n");
}

TEST(Printable, controlCharactersDoNotReachTheTerminal)
{
    EXPECT_EQ(printable("a\033[2Jb\n\x7f"), "a?[2Jb??");
    EXPECT_EQ(printable("b\xc3\xa4ume.mesh"), "b\xc3\xa4ume.mesh");
}

} // namespace lodsmith::cli
