#include "PreviewHandle.h"

#include "CeguiPreview.h"
#include "PixelsFrom.h"
#include "PreviewBinding.h"
#include <lodsmith/lua/Constants.h>
#include <lodsmith/lua/Numbers.h>

#include <string>
#include <utility>
#include <vector>

namespace lodsmith::lua {

namespace {

constexpr double kMaxLevel = 1e6; // far beyond any mesh's

/// A level as OGRE counts them.
Result<unsigned> levelFrom(double number)
{
    if (number >= 0 && number <= kMaxLevel && number == std::floor(number))
        return static_cast<unsigned>(number);
    return Error{ErrorCode::InvalidSetting, numberText(number) + " is no level: levels are counted from 0 on"};
}

} // namespace

PreviewHandle::PreviewHandle(const std::shared_ptr<CeguiPreview>& preview)
    : Handle("lodsmith::PreviewHandle"), mPreview(preview)
{
}

PreviewHandle::~PreviewHandle() = default;

template <class Work>
Returned PreviewHandle::withPreview(const Work& work) const
{
    const std::shared_ptr<CeguiPreview> preview = mPreview.lock();
    return preview ? Returned(work(preview->preview)) : Returned::failure("the preview is gone");
}

template <class Work>
Returned PreviewHandle::done(const Work& work) const
{
    return withPreview([&](MeshPreview& preview) {
        work(preview);
        return true;
    });
}

Returned PreviewHandle::show(const Mesh& mesh) const
{
    return withPreview([&](MeshPreview& preview) -> Returned {
        const Ogre::MeshPtr pointer = mesh.lock();
        return pointer ? Returned(preview.show(pointer)) : Returned::failure("the mesh is gone");
    });
}

Returned PreviewHandle::clear() const
{
    return done([](MeshPreview& preview) { preview.clear(); });
}

Returned PreviewHandle::mesh() const
{
    return withPreview([](MeshPreview& preview) -> Returned {
        return preview.mesh() ? Returned(std::make_unique<Mesh>(preview.mesh())) : Returned(nullptr);
    });
}

Returned PreviewHandle::setLevel(OptionalNumber number) const
{
    return withPreview([&](MeshPreview& preview) -> Returned {
        if (!number) {
            preview.setLevel({});
            return true;
        }
        const Result<unsigned> level = levelFrom(*number);
        if (!level)
            return level.error();
        preview.setLevel(level.value());
        return true;
    });
}

Returned PreviewHandle::shownLevel() const
{
    return withPreview([](const MeshPreview& preview) { return preview.shownLevel(); });
}

Returned PreviewHandle::triangles() const
{
    return withPreview([](const MeshPreview& preview) { return preview.triangles(); });
}

Returned PreviewHandle::setMode(double number) const
{
    return withPreview([&](MeshPreview& preview) -> Returned {
        const auto mode = constantFrom(number, ViewMode::Deviation, "ViewMode");
        if (!mode)
            return mode.error();
        preview.setMode(mode.value());
        return true;
    });
}

Returned PreviewHandle::mode() const
{
    return withPreview([](const MeshPreview& preview) { return preview.mode(); });
}

Returned PreviewHandle::note() const
{
    return withPreview([](const MeshPreview& preview) { return preview.note(); });
}

Returned PreviewHandle::compare(double modeNumber, double firstNumber, double secondNumber, double share) const
{
    return withPreview([&](MeshPreview& preview) -> Returned {
        const auto mode = constantFrom(modeNumber, CompareMode::Wipe, "CompareMode");
        const Result<unsigned> first = levelFrom(firstNumber), second = levelFrom(secondNumber);
        if (!mode || !first || !second)
            return !mode ? mode.error() : !first ? first.error() : second.error();
        if (!(share >= 0 && share <= 1))
            return Error{ErrorCode::InvalidSetting, numberText(share) + " is no share: shares are 0..1"};
        preview.compare(mode.value(), first.value(), second.value(), static_cast<float>(share));
        return true;
    });
}

Returned PreviewHandle::compareMode() const
{
    return withPreview([](const MeshPreview& preview) { return preview.compareMode(); });
}

Returned PreviewHandle::orbit(double dx, double dy) const
{
    return done([&](MeshPreview& preview) { preview.orbit(static_cast<float>(dx), static_cast<float>(dy)); });
}

Returned PreviewHandle::pan(double dx, double dy) const
{
    return done([&](MeshPreview& preview) { preview.pan(static_cast<float>(dx), static_cast<float>(dy)); });
}

Returned PreviewHandle::zoom(double steps) const
{
    return done([&](MeshPreview& preview) { preview.zoom(static_cast<float>(steps)); });
}

Returned PreviewHandle::resetCamera() const
{
    return done([](MeshPreview& preview) { preview.resetCamera(); });
}

Returned PreviewHandle::distance() const
{
    return withPreview([](const MeshPreview& preview) { return preview.distance(); });
}

Returned PreviewHandle::viewAt(double number, double value) const
{
    return withPreview([&](MeshPreview& preview) -> Returned {
        const auto strategy = constantFrom(number, Strategy::ScreenRatioPixelCount, "Strategy");
        if (!strategy)
            return strategy.error();
        return preview.viewAt(ogreName(strategy.value()), value);
    });
}

Returned PreviewHandle::resize(double width, double height) const
{
    const std::shared_ptr<CeguiPreview> preview = mPreview.lock();
    if (!preview)
        return Returned::failure("the preview is gone");
    preview->preview.resize(pixelsFrom(width), pixelsFrom(height));
    preview->image.follow();
    return true;
}

Returned PreviewHandle::image() const
{
    const std::shared_ptr<CeguiPreview> preview = mPreview.lock();
    return preview ? Returned(preview->image.name()) : Returned::failure("the preview is gone");
}

Returned PreviewHandle::animations() const
{
    return withPreview([](const MeshPreview& preview) { return Table(preview.animations()); });
}

Returned PreviewHandle::play(const OptionalText& animation) const
{
    return withPreview([&](MeshPreview& preview) { return preview.play(std::string(animation.value_or(""))); });
}

Returned PreviewHandle::animation() const
{
    return withPreview([](const MeshPreview& preview) {
        return preview.animation().empty() ? Returned(nullptr) : Returned(preview.animation());
    });
}

Returned PreviewHandle::setSpeed(double speed) const
{
    return done([&](MeshPreview& preview) { preview.setSpeed(static_cast<float>(speed)); });
}

Returned PreviewHandle::deviationScale() const
{
    return withPreview([](const MeshPreview& preview) -> Returned {
        const std::string error = preview.deviationError();
        return error.empty() ? Returned(preview.deviationScale()) : Returned::failure(error);
    });
}

Returned PreviewHandle::legend() const
{
    const std::shared_ptr<CeguiPreview> preview = mPreview.lock();
    return preview ? Returned(preview->legend.name()) : Returned::failure("the preview is gone");
}

Returned PreviewHandle::redraw() const
{
    return done([](MeshPreview& preview) { preview.redraw(); });
}

} // namespace lodsmith::lua

namespace lodsmith {

std::unique_ptr<lua::Handle> makePreviewHandle(const std::shared_ptr<CeguiPreview>& preview)
{
    return std::make_unique<lua::PreviewHandle>(preview);
}

} // namespace lodsmith
