#pragma once

#include "Canvas.h"

#include <CEGUI/String.h>

#include <string>

namespace CEGUI {
class BasicImage;
class Texture;
} // namespace CEGUI

namespace lodsmith {

/// A picture that CEGUI's windows show by its name. Belongs to the CEGUI::System there is when it is made, and may outlive it.
class LODSMITH_API CeguiImage {
public:
    /// Whether CEGUI runs and has no image of that name yet.
    static bool isFree(const std::string& name);

    /// The name must be free.
    explicit CeguiImage(const std::string& name);
    ~CeguiImage();
    CeguiImage(const CeguiImage&) = delete;
    CeguiImage& operator=(const CeguiImage&) = delete;

    const std::string& name() const { return mName; }
    /// Whether CEGUI still has it.
    bool isAlive() const;
    /// Shows a copy of the canvas; the image gets its size. Only when that changes do windows have to be invalidated.
    void show(const Canvas& canvas);

private:
    std::string mName;
    CEGUI::Texture* mTexture;
    CEGUI::BasicImage* mImage;
};

} // namespace lodsmith
