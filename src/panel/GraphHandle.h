#pragma once

#include "PanelTypes.h"

#include <memory>

namespace lodsmith::lua {

/// A Graph that Lua owns.
class GraphHandle final : public Handle {
public:
    explicit GraphHandle(std::unique_ptr<Graph> graph);
    ~GraphHandle() override;

    Returned image() const;
    Returned margin() const;
    Returned resize(double width, double height);
    Returned setCurve(const Items& points);
    Returned setMarkers(const Items& markers);
    Returned setTicks(const Items& upright, const Items& level);
    Returned draw();

private:
    std::unique_ptr<Graph> mGraph;
};

Returned newGraph(Text name);

} // namespace lodsmith::lua
