#include <lodsmith/lua/Handle.h>

namespace lodsmith::lua {

Handle::~Handle() = default;

} // namespace lodsmith::lua
