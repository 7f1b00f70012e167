#include "LayerPictures.h"

namespace lodsmith::generators {

Opacity::Opacity(double ofLeaf) : mOf{}
{
    double seenThrough = 1.0;
    for (double& opacity : mOf) {
        opacity = 1.0 - seenThrough;
        seenThrough *= 1.0 - ofLeaf;
    }
}

} // namespace lodsmith::generators
