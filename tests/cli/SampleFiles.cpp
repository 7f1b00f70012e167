#include "SampleFiles.h"

#include "MeshFile.h"
#include "ModelImport.h"
#include "OgreSession.h"

#include <cmath>
#include <sstream>

namespace lodsmith::cli::test {

std::string torusObj(unsigned segments)
{
    std::ostringstream text;
    const double step = 2.0 * std::acos(-1.0) / segments;
    for (unsigned i = 0; i < segments; ++i)
        for (unsigned j = 0; j < segments; ++j)
            text << "v " << (2 + std::cos(j * step)) * std::cos(i * step) << ' '
                 << (2 + std::cos(j * step)) * std::sin(i * step) << ' ' << std::sin(j * step) << '\n';
    for (unsigned i = 0; i <= segments; ++i)
        for (unsigned j = 0; j <= segments; ++j)
            text << "vt " << double(i) / segments << ' ' << double(j) / segments << '\n';
    const auto corner = [&](unsigned i, unsigned j) {
        text << ' ' << i % segments * segments + j % segments + 1 << '/' << i * (segments + 1) + j + 1;
    };
    text << "usemtl Stone\n";
    for (unsigned i = 0; i < segments; ++i)
        for (unsigned j = 0; j < segments; ++j) {
            text << 'f';
            corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1);
            text << '\n';
        }
    return text.str();
}

std::string torusMesh(unsigned segments, const std::string& skeleton)
{
    const lodsmith::test::TestDirectory directory;
    const std::string model = directory.write("torus.obj", torusObj(segments));
    OgreSession session;
    const Ogre::MeshPtr mesh = session.create("torus");
    if (!importModel(model, *mesh))
        throw std::runtime_error("the sample cannot be imported");
    if (!skeleton.empty())
        mesh->setSkeletonName(skeleton);
    return meshBytes(*mesh, {}).value();
}

} // namespace lodsmith::cli::test
