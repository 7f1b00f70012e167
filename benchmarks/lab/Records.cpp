#include "Records.h"

namespace lodsmith::benchmarks {

const char* toString(LevelTarget::Kind kind)
{
    switch (kind) {
    case LevelTarget::Kind::Proportional: return "proportional";
    case LevelTarget::Kind::Constant: return "constant";
    case LevelTarget::Kind::Triangles: return "triangles";
    case LevelTarget::Kind::Deviation: return "deviation";
    case LevelTarget::Kind::CollapseCost: return "collapsecost";
    }
    return "unknown";
}

} // namespace lodsmith::benchmarks
