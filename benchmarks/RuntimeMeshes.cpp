#include "RuntimeMeshes.h"

#include "LodsmithPeer.h"

namespace lodsmith::benchmarks {

LodConfig halvedLevels(const Ogre::MeshPtr& mesh)
{
    return levelsAtDistances(mesh, targetsOf(halvings()));
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
