#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <memory>
#include <string>
#include <vector>

namespace lodsmith {

class Canvas;
class CeguiImage;

/// A point of a graph: shares of its width and height, 0..1, y upwards.
struct GraphPoint {
    float x = 0;
    float y = 0;
};

struct GraphMarker {
    GraphPoint at;
    bool selected = false;
};

/// A curve with markers and ticks, painted in software into a CEGUI image, under any renderer of CEGUI's. Scales and labels are
/// the caller's.
///
/// Belongs to the CEGUI::System there is when it is made, and may outlive it. Main thread only.
class LODSMITH_API Graph {
public:
    /// Pixels between the plot, which the shares are of, and the edges of the image.
    static constexpr unsigned kMargin = 7;

    /// Errors: InvalidSetting for a name that is taken, NotFound without CEGUI.
    static Result<std::unique_ptr<Graph>> create(const std::string& name);
    ~Graph();
    Graph(const Graph&) = delete;
    Graph& operator=(const Graph&) = delete;

    /// What CEGUI's windows call the image.
    const std::string& image() const;

    /// Pixels; at least 1, at most 4096 are used.
    void resize(unsigned width, unsigned height);
    /// Points are joined in their order. What is not a number is left out.
    void setCurve(std::vector<GraphPoint> points) { mCurve = std::move(points); }
    void setMarkers(std::vector<GraphMarker> markers) { mMarkers = std::move(markers); }
    /// Lines across the plot: upright ones at shares of its width, level ones at shares of its height.
    void setTicks(std::vector<float> upright, std::vector<float> level);

    /// Paints, and shows what it painted. After a change of size windows that show the image have to be invalidated.
    /// Errors: NotFound when CEGUI is gone.
    Result<Done> draw();

private:
    explicit Graph(const std::string& name);
    GraphPoint onCanvas(const GraphPoint& point) const;
    void paintTicks(Canvas& canvas) const;
    void paintCurve(Canvas& canvas) const;
    void paintMarkers(Canvas& canvas) const;

    std::unique_ptr<CeguiImage> mImage;
    unsigned mWidth = 1;
    unsigned mHeight = 1;
    std::vector<GraphPoint> mCurve;
    std::vector<GraphMarker> mMarkers;
    std::vector<float> mUpright;
    std::vector<float> mLevel;
};

} // namespace lodsmith
