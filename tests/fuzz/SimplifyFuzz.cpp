// libFuzzer target for the core: any bytes make a mesh, options and targets; whatever comes out has to be a named error or
// a chain that breaks no invariant.

#include "support/Invariants.h"
#include "support/MeshFromBytes.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace lodsmith;

[[noreturn]] void fail(const std::string& sentence)
{
    std::fprintf(stderr, "%s\n", sentence.c_str());
    std::abort();
}

bool isNamed(ErrorCode code)
{
    return code == ErrorCode::InvalidGeometry || code == ErrorCode::IndexOutOfRange
           || code == ErrorCode::InvalidSetting;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    test::ByteSource bytes(data, size);
    const bool trusted = bytes.flag();
    const test::SimplifyCase made = test::caseFromBytes(bytes, trusted ? test::Trust::Valid : test::Trust::Garbage);
    const MeshView view = made.mesh.view();
    const Result<LodChain> result = simplify(view, made.targets, made.options);
    if (!result) {
        if (trusted || !isNamed(result.error().code))
            fail("refused: " + describe(result.error()));
        return 0;
    }
    const std::vector<std::string> broken =
        test::brokenInvariants(view, made.targets, made.options, result.value(), test::InvariantOptions{60});
    if (!broken.empty())
        fail(broken.front());
    return 0;
}
