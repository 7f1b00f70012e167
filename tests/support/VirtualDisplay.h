#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

namespace lodsmith::test {

/// An X server of its own (Xvfb, with GLX), which shows its screen to nobody; the environment's DISPLAY names it for as long
/// as this object lives. It ends with the object, and with the process, however that ends.
class VirtualDisplay {
public:
    /// Whether Xvfb is installed.
    static bool isAvailable();

    /// Waits until the server is ready. Throws std::runtime_error when it does not start.
    /// @param width pixels of its screen
    explicit VirtualDisplay(int width = 1600, int height = 1200);
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

private:
    pid_t mServer = -1;
    std::optional<std::string> mBefore; ///< DISPLAY of the environment
};

} // namespace lodsmith::test
