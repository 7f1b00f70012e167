#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lodsmith::cli {

// report.css and report.js, as they are.
extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;

/// A whole HTML document that asks for nothing from elsewhere and runs no script but its own.
/// @param title plain text
/// @param body  HTML
std::string htmlPage(const std::string& title, const std::string& body);

/// An element with its content, which is HTML.
std::string element(const std::string& name, const std::string& content, const std::string& style = "");

/// Figures side by side, each under its name; both are HTML.
std::string keyFigures(const std::vector<std::pair<std::string, std::string>>& figures);

/// What the figures of every page rest on.
std::string reportFooter();

/// A table that may be wider than the page: it is moved sideways within its own frame, also with the keys.
/// @param label plain text, what it holds
/// @param table HTML
std::string tableFrame(const std::string& label, const std::string& table);

} // namespace lodsmith::cli
