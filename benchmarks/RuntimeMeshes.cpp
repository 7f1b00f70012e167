#include "RuntimeMeshes.h"

#include "Peer.h"

namespace lodsmith::benchmarks {

LodConfig halvedLevels(const Ogre::MeshPtr& mesh)
{
    LodConfig config;
    config.mesh = mesh;
    Ogre::Real distance = 0;
    for (const LevelTarget& target : halvings())
        config.levels.push_back({distance += 100, target, ""});
    return config;
}

std::vector<std::unique_ptr<Subject>> subjectsUpTo(std::uint32_t triangles)
{
    std::vector<std::unique_ptr<Subject>> subjects;
    for (const SubjectSource& source : allSubjects({}))
        if (auto subject = source.load(); subject->triangles() <= triangles)
            subjects.push_back(std::move(subject));
    return subjects;
}

} // namespace lodsmith::benchmarks
