#include "EditorSession.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith::test {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::seconds(60);
constexpr auto kPause = std::chrono::milliseconds(5);

bool isInstalled(const std::string& program)
{
    return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

std::string quoted(const std::string& text)
{
    std::string result = "'";
    for (const char character : text)
        result += character == '\'' ? std::string("'\\''") : std::string(1, character);
    return result + "'";
}

int exitStatus(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The child's part.
[[noreturn]] void becomeEditor(const std::vector<std::string>& arguments, const fs::path& directory)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int output = ::open((directory / "errors").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
    ::setenv("LODSMITH_TEST_DIRECTORY", directory.c_str(), 1);
    ::setenv("XDG_CONFIG_HOME", (directory / "config").c_str(), 1);
    ::setenv("XDG_CACHE_HOME", (directory / "cache").c_str(), 1);
    std::vector<const char*> words{LODSMITH_EDITOR, "--script", LODSMITH_TEST_SCRIPTS "/answer.lua"};
    for (const std::string& argument : arguments)
        words.push_back(argument.c_str());
    words.push_back(nullptr);
    ::execv(LODSMITH_EDITOR, const_cast<char* const*>(words.data()));
    ::_exit(127);
}

} // namespace

bool EditorSession::isAvailable()
{
    return VirtualDisplay::isAvailable() && isInstalled("xdotool");
}

EditorSession::EditorSession(const std::vector<std::string>& arguments, ScreenPoint screen)
    : mDisplay(screen.x, screen.y)
{
    start(arguments);
    ask("true");
    findWindow();
}

EditorSession::~EditorSession()
{
    if (isAlive()) {
        ::kill(mEditor, SIGKILL);
        ::waitpid(mEditor, nullptr, 0);
    }
}

/// Without a window manager nobody gives it the keyboard.
void EditorSession::findWindow()
{
    const fs::path geometry = mDirectory / "geometry";
    run("xdotool search --sync --onlyvisible --name Lodsmith windowfocus --sync getwindowgeometry --shell > "
        + quoted(geometry.string()));
    std::ifstream lines(geometry);
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("X=", 0) == 0)
            mWindow.x = std::stoi(line.substr(2));
        else if (line.rfind("Y=", 0) == 0)
            mWindow.y = std::stoi(line.substr(2));
}

void EditorSession::start(const std::vector<std::string>& arguments)
{
    mEditor = ::fork();
    if (mEditor == 0)
        becomeEditor(arguments, mDirectory.path());
    if (mEditor < 0)
        throw std::runtime_error("no process for the editor");
}

void EditorSession::run(const std::string& command) const
{
    if (const int status = std::system(command.c_str()); status != 0)
        throw std::runtime_error("failed: " + command);
}

std::string EditorSession::ask(const std::string& expression)
{
    const fs::path question = mDirectory / ("question" + std::to_string(mQuestions++));
    std::ofstream(question.string() + ".new") << expression;
    fs::rename(question.string() + ".new", question);
    const fs::path answer = question.string() + ".answer";
    for (const auto start = Clock::now(); !fs::exists(answer); std::this_thread::sleep_for(kPause))
        if (!isAlive() || Clock::now() - start > kPatience)
            throw std::runtime_error("no answer to \"" + expression + "\"; status " + std::to_string(mStatus) + "; "
                                     + errors());
    std::string value = contentOf(answer);
    fs::remove(answer);
    fs::remove(question);
    return value;
}

bool EditorSession::waitFor(const std::string& condition)
{
    for (const auto start = Clock::now(); Clock::now() - start < kPatience; std::this_thread::sleep_for(kPause))
        if (ask(condition) == "true")
            return true;
    return false;
}

ScreenPoint EditorSession::at(const std::string& window, double right, double down)
{
    const std::string area = ask("screenAreaOf(" + quoted(window) + ")");
    if (area == "none")
        throw std::runtime_error("no window \"" + window + "\" is shown");
    return pointIn(area, right, down);
}

ScreenPoint EditorSession::middleOf(const std::string& expression)
{
    return pointIn(ask("areaOf(" + expression + ")"), 0.5, 0.5);
}

ScreenPoint EditorSession::pointIn(const std::string& area, double right, double down) const
{
    std::istringstream numbers(area);
    int left = 0, top = 0, rightEdge = 0, bottom = 0;
    if (!(numbers >> left >> top >> rightEdge >> bottom))
        throw std::runtime_error("no area of a window: " + area);
    return {mWindow.x + int(left + right * (rightEdge - left)), mWindow.y + int(top + down * (bottom - top))};
}

void EditorSession::move(ScreenPoint to)
{
    run("xdotool mousemove --sync " + std::to_string(to.x) + " " + std::to_string(to.y));
}

void EditorSession::click(ScreenPoint point, int button)
{
    press(point, button);
    release(button);
}

void EditorSession::press(ScreenPoint point, int button)
{
    move(point);
    run("xdotool mousedown " + std::to_string(button));
}

void EditorSession::release(int button)
{
    run("xdotool mouseup " + std::to_string(button));
}

void EditorSession::key(const std::string& keys)
{
    run("xdotool key " + quoted(keys));
}

void EditorSession::type(const std::string& text)
{
    run("xdotool type --delay 5 -- " + quoted(text));
}

bool EditorSession::isAlive()
{
    int status = 0;
    if (mEditor > 0 && ::waitpid(mEditor, &status, WNOHANG) == mEditor) {
        mEditor = -1;
        mStatus = exitStatus(status);
    }
    return mEditor > 0;
}

int EditorSession::wait()
{
    for (const auto start = Clock::now(); isAlive(); std::this_thread::sleep_for(kPause))
        if (Clock::now() - start > kPatience)
            return -1;
    return mStatus;
}

std::string EditorSession::errors() const
{
    return contentOf(mDirectory / "errors");
}

} // namespace lodsmith::test
