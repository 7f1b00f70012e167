#include "PageParts.h"

#include "HtmlText.h"

namespace lodsmith::cli {

namespace {

// Whatever a page might hold, it loads nothing but pictures that are part of the report.
constexpr const char* kPolicy = "default-src 'none'; img-src 'self' file: data:; style-src 'unsafe-inline'; "
                                "script-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";

} // namespace

std::string htmlPage(const std::string& title, const std::string& body)
{
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                       "<meta http-equiv=\"Content-Security-Policy\" content=\"";
    html += kPolicy;
    html += "\">\n<meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"generator\" content=\"lodsmith\">\n"
            "<link rel=\"icon\" href=\"data:,\">\n<title>"
            + escaped(title) + "</title>\n<style>\n";
    html += kReportStyle;
    html += "</style>\n<script>\n";
    html += kReportScript;
    html += "</script>\n</head>\n<body>\n" + body + "</body>\n</html>\n";
    return html;
}

std::string element(const std::string& name, const std::string& content, const std::string& style)
{
    return "<" + name + (style.empty() ? "" : " class=\"" + style + "\"") + ">" + content + "</" + name + ">\n";
}

std::string keyFigures(const std::vector<std::pair<std::string, std::string>>& figures)
{
    std::string html;
    for (const auto& [name, value] : figures)
        html.append("<div><dt>").append(name).append("</dt><dd>").append(value).append("</dd></div>\n");
    return element("dl", html, "key-figures");
}

std::string reportFooter()
{
    return element(
        "footer",
        "<p>Visible error: the largest distance between a level's surface and the original's, in pixels where the "
        "level appears, 1080 pixels high with a vertical field of view of 45 degrees. Averages over distances go from "
        "a radius of 540 pixels to one of 4, every doubling of the distance counting the same. "
        "docs/report.md of Lodsmith explains each figure; report.json has them all.</p>\n");
}

std::string tableFrame(const std::string& label, const std::string& table)
{
    return "<div class=\"table-frame\" role=\"region\" tabindex=\"0\" aria-label=\"" + escaped(label) + "\">\n" + table
           + "</div>\n";
}

} // namespace lodsmith::cli
