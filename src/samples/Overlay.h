#pragma once

#include <string>

namespace Ogre {
class OverlayElement;
class Viewport;
} // namespace Ogre

namespace lodsmith::samples {

/// Some lines of text in a corner of the window, for as long as the program draws.
class Overlay {
public:
    explicit Overlay(const Ogre::Viewport& viewport);
    void show(const std::string& text);

private:
    Ogre::OverlayElement* mText = nullptr;
};

} // namespace lodsmith::samples
