#pragma once

#include <lodsmith/core/MeshView.h>
#include <lodsmith/ogre/MeshReader.h>

#include <OgreMesh.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// Triangle lists of one level, one for each SubMeshView of the original.
using LevelIndices = std::vector<std::vector<std::uint32_t>>;

/// A mesh that is measured: loaded in OGRE for those that work on it there, and as plain arrays for the rest.
class Subject {
public:
    Subject(std::string name, Ogre::MeshPtr mesh);
    ~Subject();
    Subject(const Subject&) = delete;
    Subject& operator=(const Subject&) = delete;

    const std::string& name() const { return mName; }
    const Ogre::MeshPtr& mesh() const { return mMesh; }
    const MeshView& view() const { return mData.value().view(); }
    std::uint32_t triangles() const { return mTriangles; }
    bool hasUvs() const;
    bool hasNormals() const;

    /// Takes all LOD levels off the OGRE mesh.
    void removeLevels();

    /// Level `stored` of the OGRE mesh (1 = the first after the original), without the single degenerate triangle that
    /// stands for an empty submesh.
    LevelIndices storedLevel(unsigned short stored) const;

private:
    std::string mName;
    Ogre::MeshPtr mMesh;
    Result<MeshData> mData;
    std::uint32_t mTriangles = 0;
};

/// The original with a level's triangles. Both have to outlive the view.
MeshView levelView(const MeshView& original, const LevelIndices& level);

/// A subject by name, not loaded yet.
struct SubjectSource {
    std::string name;
    std::string origin;  ///< the file, or the name of a tessellation: unlike the name, no two sources have one
    double weight = 0.0; ///< about how many bytes it has, by which the time for it can be guessed
    std::function<std::unique_ptr<Subject>()> load; ///< throws std::runtime_error or Ogre::Exception
};

/// The tessellations whose times show how cost grows: one surface from 1k to 1M triangles.
std::vector<SubjectSource> scalingSubjects();

/// Their surface with 10M triangles, which nobody but us is asked for: OGRE would take minutes.
SubjectSource hugeSubject();

/// Everything that is measured: the .mesh files under the media directories, then tessellations up to 1M triangles.
/// @param furtherMedia  besides the project's own media and LODSMITH_EXTRA_MEDIA; directories are searched in depth
std::vector<SubjectSource> allSubjects(const std::vector<std::string>& furtherMedia);

/// The source of an origin. Throws std::runtime_error where there is none.
SubjectSource sourceFrom(const std::string& origin);

/// What a user asks for: everything when `wishes` is empty, else in the order of the wishes the .mesh files of a directory
/// (searched in depth), a file, or those of allSubjects({}) whose name matches a pattern with * and ?. Throws
/// std::runtime_error for a wish that nothing answers to.
std::vector<SubjectSource> chosenSubjects(const std::vector<std::string>& wishes);

} // namespace lodsmith::benchmarks
