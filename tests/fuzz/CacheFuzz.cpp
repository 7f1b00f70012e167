// libFuzzer target for entries of the cache: any bytes are read as an entry, and as what an entry holds behind its checksum.
// What is accepted has to be exactly what is written of the chain that came out.

#include "EntryCodec.h"

#include <cstdio>
#include <cstdlib>

namespace {

using namespace lodsmith;

[[noreturn]] void fail(const char* sentence)
{
    std::fprintf(stderr, "%s\n", sentence);
    std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const CacheKey key;
    if (const auto chain = decodeEntry(key, bytes); chain && encodeEntry(key, *chain) != bytes)
        fail("an entry was read that would be written otherwise");
    const auto chain = decodePayload(bytes);
    if (!chain)
        return 0;
    if (encodePayload(*chain) != bytes)
        fail("a payload was read that would be written otherwise");
    if (!decodeEntry(key, encodeEntry(key, *chain)))
        fail("an entry was written that is not read");
    return 0;
}
