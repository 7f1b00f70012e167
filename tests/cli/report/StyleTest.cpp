#include "report/PageParts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

namespace lodsmith::cli {

namespace {

using Colours = std::map<std::string, std::string>;

/// What the style sheet calls its colours, once for each theme, in the order in which it has them: light, dark by the
/// button, dark by the system, print.
std::vector<Colours> themes()
{
    std::vector<Colours> themes;
    const std::string style(kReportStyle);
    const std::regex line("color-scheme: (light|dark);|--([a-z0-9-]+): #([0-9a-f]{6});");
    for (std::sregex_iterator match(style.begin(), style.end(), line), end; match != end; ++match)
        if ((*match)[1].matched)
            themes.emplace_back();
        else if (!themes.empty())
            themes.back()[(*match)[2]] = (*match)[3];
    return themes;
}

/// Relative luminance (WCAG 2.1).
double luminance(const std::string& colour)
{
    const double weights[3] = {0.2126, 0.7152, 0.0722};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double part = std::stoi(colour.substr(2 * i, 2), nullptr, 16) / 255.0;
        sum += weights[i] * (part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
    }
    return sum;
}

double contrast(const std::string& a, const std::string& b)
{
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

} // namespace

TEST(ReportStyle, textHasContrastInEveryTheme)
{
    ASSERT_EQ(themes().size(), 4u);
    for (const Colours& theme : themes()) {
        for (const char* ground : {"page", "card", "shade"}) {
            for (const char* text : {"text", "faint", "link", "alarm"})
                EXPECT_GE(contrast(theme.at(text), theme.at(ground)), 4.5) << text << " on " << ground;
            for (const char* line : {"series1", "series2", "series3", "series4"})
                EXPECT_GE(contrast(theme.at(line), theme.at(ground)), 3.0) << line << " on " << ground;
        }
        EXPECT_GE(contrast(theme.at("text"), theme.at("alarm-shade")), 4.5);
    }
}

TEST(ReportStyle, theButtonAndTheSystemGiveTheSameDark)
{
    EXPECT_EQ(themes().at(1), themes().at(2));
}

} // namespace lodsmith::cli
