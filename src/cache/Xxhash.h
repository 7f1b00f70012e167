#pragma once

// Compiled in rather than linked to: faster for short pieces, and nothing that users of the library would have to find.
#define XXH_INLINE_ALL
#include <xxhash.h>
