#include "GraphHandle.h"

#include "PixelsFrom.h"

#include <utility>

namespace lodsmith::lua {

GraphHandle::GraphHandle(std::unique_ptr<Graph> graph) : Handle("lodsmith::GraphHandle"), mGraph(std::move(graph)) {}

GraphHandle::~GraphHandle() = default;

Returned GraphHandle::image() const
{
    return mGraph->image();
}

Returned GraphHandle::margin() const
{
    return Graph::kMargin;
}

Returned GraphHandle::resize(double width, double height)
{
    mGraph->resize(pixelsFrom(width), pixelsFrom(height));
    return true;
}

Returned GraphHandle::setCurve(const Items& points)
{
    const auto markers = points.markers();
    if (!markers)
        return markers.error();
    std::vector<GraphPoint> curve;
    for (const GraphMarker& marker : markers.value())
        curve.push_back(marker.at);
    mGraph->setCurve(std::move(curve));
    return true;
}

Returned GraphHandle::setMarkers(const Items& items)
{
    auto markers = items.markers();
    if (!markers)
        return markers.error();
    mGraph->setMarkers(std::move(markers).value());
    return true;
}

Returned GraphHandle::setTicks(const Items& uprightItems, const Items& levelItems)
{
    auto upright = uprightItems.numbers(), level = levelItems.numbers();
    if (!upright || !level)
        return upright ? level.error() : upright.error();
    mGraph->setTicks(std::move(upright).value(), std::move(level).value());
    return true;
}

Returned GraphHandle::draw()
{
    return mGraph->draw();
}

Returned newGraph(Text name)
{
    auto graph = Graph::create(std::string(name));
    if (!graph)
        return graph.error();
    return std::make_unique<GraphHandle>(std::move(graph).value());
}

} // namespace lodsmith::lua
