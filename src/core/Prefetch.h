#pragma once

#if defined(_MSC_VER)
#    include <intrin.h>
#endif

namespace lodsmith {

/// Asks for a cache line that will be needed soon. Any address will do.
inline void prefetch(const void* address)
{
#if defined(_MSC_VER)
    _mm_prefetch(static_cast<const char*>(address), _MM_HINT_T0);
#else
    __builtin_prefetch(address);
#endif
}

} // namespace lodsmith
