#pragma once

#include <support/TestDirectory.h>

#include <CEGUI/DefaultResourceProvider.h>

namespace CEGUI {
class NullRenderer;
} // namespace CEGUI

namespace lodsmith::test {

/// CEGUI that draws nothing, with the skin TaharezLook, for as long as this object lives; one at a time.
class NullGui {
public:
    NullGui();
    ~NullGui();
    NullGui(const NullGui&) = delete;
    NullGui& operator=(const NullGui&) = delete;

private:
    TestDirectory mDirectory; ///< of the log
    CEGUI::DefaultResourceProvider mFiles;
    CEGUI::NullRenderer& mRenderer;
};

} // namespace lodsmith::test
