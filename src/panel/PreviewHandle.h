#pragma once

#include "PanelTypes.h"

#include <lodsmith/lua/Mesh.h>

#include <memory>

namespace lodsmith {
struct CeguiPreview;
} // namespace lodsmith

namespace lodsmith::lua {

/// The panel's preview, which goes with the panel.
class PreviewHandle final : public Handle {
public:
    explicit PreviewHandle(const std::shared_ptr<CeguiPreview>& preview);
    ~PreviewHandle() override;

    Returned show(const Mesh& mesh) const;
    Returned clear() const;
    Returned mesh() const;
    Returned setLevel(OptionalNumber level) const;
    Returned shownLevel() const;
    Returned triangles() const;
    Returned setMode(double mode) const;
    Returned mode() const;
    Returned note() const;
    Returned compare(double mode, double first, double second, double share) const;
    Returned compareMode() const;
    Returned orbit(double dx, double dy) const;
    Returned pan(double dx, double dy) const;
    Returned zoom(double steps) const;
    Returned resetCamera() const;
    Returned distance() const;
    Returned viewAt(double strategy, double value) const;
    Returned resize(double width, double height) const;
    Returned image() const;
    Returned animations() const;
    Returned play(const OptionalText& animation) const;
    Returned animation() const;
    Returned setSpeed(double speed) const;
    Returned deviationScale() const;
    Returned legend() const;
    Returned redraw() const;

private:
    template <class Work>
    Returned withPreview(const Work& work) const;
    template <class Work>
    Returned done(const Work& work) const;

    std::weak_ptr<CeguiPreview> mPreview;
};

} // namespace lodsmith::lua
