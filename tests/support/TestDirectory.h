#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lodsmith::test {

/// An empty directory that is gone, with all that is in it, when the object is.
class TestDirectory {
public:
    TestDirectory();
    ~TestDirectory();
    TestDirectory(const TestDirectory&) = delete;
    TestDirectory& operator=(const TestDirectory&) = delete;

    const std::filesystem::path& path() const { return mPath; }
    std::filesystem::path operator/(const std::string& name) const { return mPath / name; }

    /// Writes a file, with its directories, and returns its path.
    std::string write(const std::string& name, const std::string& content) const;

    /// All files at any depth, relative and sorted.
    std::vector<std::string> files() const;

private:
    std::filesystem::path mPath;
};

std::string contentOf(const std::filesystem::path& path);

} // namespace lodsmith::test
