#pragma once

#include <lodsmith/core/Export.h>

#include <string>

namespace CEGUI {
class BasicImage;
class OgreTexture;
} // namespace CEGUI

namespace lodsmith {

class MeshPreview;

/// What a preview draws, as an image that CEGUI's windows show by its name. CEGUI draws with OgreRenderer, and outlives it.
class LODSMITH_API PreviewImage {
public:
    /// The preview lives longer than it does.
    explicit PreviewImage(const MeshPreview& preview);
    ~PreviewImage();
    PreviewImage(const PreviewImage&) = delete;
    PreviewImage& operator=(const PreviewImage&) = delete;

    const std::string& name() const { return mName; }
    /// To be called when the preview has got another size. Windows that show the image have to be invalidated then.
    void follow();

private:
    const MeshPreview& mPreview;
    std::string mName;
    CEGUI::OgreTexture* mTexture;
    CEGUI::BasicImage* mImage;
};

} // namespace lodsmith
