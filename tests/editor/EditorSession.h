#pragma once

#include <support/TestDirectory.h>
#include <support/VirtualDisplay.h>

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace lodsmith::test {

/// A point on the screen, pixels from its left upper corner.
struct ScreenPoint {
    int x = 0;
    int y = 0;
};

/// lodsmith-editor on a screen of its own, with a person's hands: moves the mouse and presses keys through the X server. What is
/// behind the screen is asked for in Lua. Settings and cache are in a directory of its own. Ends with the object.
class EditorSession {
public:
    /// Whether the programs that it takes are installed.
    static bool isAvailable();

    /// Starts it and waits until it answers. Throws std::runtime_error when it does not.
    explicit EditorSession(const std::vector<std::string>& arguments, ScreenPoint screen = {1280, 1024});
    ~EditorSession();
    EditorSession(const EditorSession&) = delete;
    EditorSession& operator=(const EditorSession&) = delete;

    /// The value of a Lua expression in the editor, as text. Throws std::runtime_error, with what the editor has printed, when
    /// it has ended or does not answer for a minute; an error in the expression is "error: ...".
    std::string ask(const std::string& expression);
    /// Runs statements.
    void tell(const std::string& statements) { ask("(function() " + statements + " end)()"); }
    /// Asks until a condition holds. False when it does not within a minute.
    bool waitFor(const std::string& condition);

    /// The middle of a CEGUI window that can be seen, or another point of it in shares of its size. Its name is the last part of its path.
    ScreenPoint at(const std::string& window, double right = 0.5, double down = 0.5);
    /// The middle of a window that a Lua expression gives.
    ScreenPoint middleOf(const std::string& expression);
    void move(ScreenPoint to);
    void click(ScreenPoint at, int button = 1);
    void click(const std::string& window) { click(at(window)); }
    void press(ScreenPoint at, int button = 1);
    void release(int button = 1);
    /// Keys as xdotool names them: "ctrl+z", "Return", "Tab".
    void key(const std::string& keys);
    void type(const std::string& text);

    /// Several of xdotool's commands in a row.
    void perform(const std::string& commands) { run("xdotool" + commands); }

    /// Whether it still runs.
    bool isAlive();
    /// Waits until it has ended. Its exit status; 128 and the signal when it was killed; -1 when it goes on for a minute.
    int wait();
    /// What it has printed so far.
    std::string errors() const;
    const std::filesystem::path& directory() const { return mDirectory.path(); }

private:
    void start(const std::vector<std::string>& arguments);
    void run(const std::string& command) const;
    void findWindow();
    ScreenPoint pointIn(const std::string& area, double right, double down) const;

    VirtualDisplay mDisplay;
    TestDirectory mDirectory;
    pid_t mEditor = -1;
    int mStatus = -1;
    ScreenPoint mWindow; ///< its left upper corner
    int mQuestions = 0;
};

} // namespace lodsmith::test
