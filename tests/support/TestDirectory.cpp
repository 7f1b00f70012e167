#include "TestDirectory.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <stdlib.h>

namespace fs = std::filesystem;

namespace lodsmith::test {

TestDirectory::TestDirectory()
{
    std::string pattern = (fs::temp_directory_path() / "lodsmith-test-XXXXXX").string();
    if (!::mkdtemp(pattern.data()))
        throw std::runtime_error("no temporary directory");
    mPath = pattern;
}

TestDirectory::~TestDirectory()
{
    std::error_code ignored;
    fs::remove_all(mPath, ignored);
}

std::string TestDirectory::write(const std::string& name, const std::string& content) const
{
    const fs::path path = mPath / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << content;
    return path.string();
}

std::vector<std::string> TestDirectory::files() const
{
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(mPath))
        if (!entry.is_directory())
            names.push_back(entry.path().lexically_relative(mPath).string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace lodsmith::test
