#include "ModelImport.h"

#include "Numbers.h"
#include "OgreSession.h"

#include <OgreHardwareBufferManager.h>
#include <OgreSubMesh.h>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <cmath>
#include <cstring>

#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

constexpr float kHardEdgeDegrees = 60.0f;
// The highest 16-bit index restarts strips on some hardware.
constexpr unsigned kMost16BitVertices = 65535;

Error fail(ErrorCode code, std::string message, const fs::path& path)
{
    Error error{code, std::move(message)};
    error.file = path.string();
    return error;
}

Result<Done> checkReadable(const fs::path& path)
{
    std::error_code code;
    if (!fs::exists(path, code))
        return fail(ErrorCode::NotFound, "no such file", path);
    if (!fs::is_regular_file(path, code))
        return fail(ErrorCode::Io, "is no regular file", path);
    if (::access(path.c_str(), R_OK) != 0)
        return fail(ErrorCode::Io, std::string("cannot be opened: ") + std::strerror(errno), path);
    return Done{};
}

/// Builds the mesh while it walks over the nodes of a scene.
class MeshBuilder {
public:
    MeshBuilder(const aiScene& scene, Ogre::Mesh& mesh, ImportReport& report)
        : mScene(scene), mMesh(mesh), mReport(report)
    {
    }

    Result<Done> addNode(const aiNode& node, const aiMatrix4x4& parent)
    {
        const aiMatrix4x4 transform = parent * node.mTransformation;
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            if (auto added = addMesh(*mScene.mMeshes[node.mMeshes[i]], transform); !added)
                return added;
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            if (auto added = addNode(*node.mChildren[i], transform); !added)
                return added;
        return Done{};
    }

    void finish()
    {
        mMesh._setBounds(mBounds, false);
        mMesh._setBoundingSphereRadius(std::sqrt(mSquaredRadius));
    }

private:
    /// Puts one vertex after the other into a buffer.
    class VertexWriter {
    public:
        explicit VertexWriter(void* target) : mTarget(static_cast<char*>(target)) {}

        template <class T>
        void put(const T* values, std::size_t count)
        {
            std::memcpy(mTarget, values, count * sizeof(T));
            mTarget += count * sizeof(T);
        }

    private:
        char* mTarget;
    };

    Result<Done> addMesh(const aiMesh& source, const aiMatrix4x4& transform)
    {
        if (source.mNumFaces == 0 || source.mNumVertices == 0)
            return Done{};
        Ogre::SubMesh& subMesh = *mMesh.createSubMesh();
        subMesh.useSharedVertices = false;
        nameMaterial(source, subMesh);
        if (auto written = addVertices(source, transform, subMesh); !written)
            return written;
        // A mirrored node turns its triangles inside out.
        addTriangles(source, transform.Determinant() < 0.0f, subMesh);
        ++mReport.subMeshes;
        mReport.vertices += source.mNumVertices;
        mReport.triangles += source.mNumFaces;
        return Done{};
    }

    void nameMaterial(const aiMesh& source, Ogre::SubMesh& subMesh) const
    {
        std::string name = mScene.mMaterials[source.mMaterialIndex]->GetName().C_Str();
        if (name.empty())
            name = "material" + std::to_string(source.mMaterialIndex);
        OgreSession::provideMaterial(mMesh, name);
        subMesh.setMaterialName(name, mMesh.getGroup());
    }

    static void declare(const aiMesh& source, Ogre::VertexDeclaration& declaration)
    {
        std::size_t offset = 0;
        const auto add = [&](Ogre::VertexElementType type, Ogre::VertexElementSemantic semantic,
                             unsigned short index = 0) {
            offset += declaration.addElement(0, offset, type, semantic, index).getSize();
        };
        add(Ogre::VET_FLOAT3, Ogre::VES_POSITION);
        if (source.HasNormals())
            add(Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
        if (source.HasVertexColors(0))
            add(Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
        for (unsigned short set = 0; set < AI_MAX_NUMBER_OF_TEXTURECOORDS && source.HasTextureCoords(set); ++set)
            add(source.mNumUVComponents[set] == 3 ? Ogre::VET_FLOAT3 : Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES,
                set);
    }

    Result<Done> addVertices(const aiMesh& source, const aiMatrix4x4& transform, Ogre::SubMesh& subMesh)
    {
        subMesh.vertexData = new Ogre::VertexData();
        subMesh.vertexData->vertexCount = source.mNumVertices;
        declare(source, *subMesh.vertexData->vertexDeclaration);
        const auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
            subMesh.vertexData->vertexDeclaration->getVertexSize(0), source.mNumVertices,
            Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
        subMesh.vertexData->vertexBufferBinding->setBinding(0, buffer);

        aiMatrix3x3 normalTransform(transform);
        normalTransform.Inverse().Transpose();
        const Ogre::HardwareBufferLockGuard lock(buffer, Ogre::HardwareBuffer::HBL_DISCARD);
        VertexWriter writer(lock.pData);
        for (unsigned i = 0; i < source.mNumVertices; ++i) {
            const aiVector3D position = transform * source.mVertices[i];
            if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z))
                return notFinite(i);
            grow(position);
            writer.put(&position.x, 3);
            putAttributes(source, i, normalTransform, writer);
        }
        return Done{};
    }

    static void putAttributes(const aiMesh& source, unsigned i, const aiMatrix3x3& normalTransform,
                              VertexWriter& writer)
    {
        if (source.HasNormals()) {
            const aiVector3D normal = (normalTransform * source.mNormals[i]).NormalizeSafe();
            writer.put(&normal.x, 3);
        }
        if (source.HasVertexColors(0)) {
            const aiColor4D& colour = source.mColors[0][i];
            const Ogre::uint32 bytes = Ogre::ColourValue(colour.r, colour.g, colour.b, colour.a).getAsBYTE();
            writer.put(&bytes, 1);
        }
        for (unsigned set = 0; set < AI_MAX_NUMBER_OF_TEXTURECOORDS && source.HasTextureCoords(set); ++set)
            writer.put(&source.mTextureCoords[set][i].x, source.mNumUVComponents[set] == 3 ? 3 : 2);
    }

    static void addTriangles(const aiMesh& source, bool mirrored, Ogre::SubMesh& subMesh)
    {
        const bool narrow = source.mNumVertices <= kMost16BitVertices;
        const std::size_t count = 3 * std::size_t(source.mNumFaces);
        subMesh.indexData->indexCount = count;
        subMesh.indexData->indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
            narrow ? Ogre::HardwareIndexBuffer::IT_16BIT : Ogre::HardwareIndexBuffer::IT_32BIT, count,
            Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
        const Ogre::HardwareBufferLockGuard lock(subMesh.indexData->indexBuffer, Ogre::HardwareBuffer::HBL_DISCARD);
        VertexWriter writer(lock.pData);
        for (unsigned face = 0; face < source.mNumFaces; ++face)
            for (const unsigned corner : {0u, mirrored ? 2u : 1u, mirrored ? 1u : 2u}) {
                const Ogre::uint32 wide = source.mFaces[face].mIndices[corner];
                const auto small = static_cast<Ogre::uint16>(wide);
                narrow ? writer.put(&small, 1) : writer.put(&wide, 1);
            }
    }

    void grow(const aiVector3D& position)
    {
        const Ogre::Vector3 point(position.x, position.y, position.z);
        mBounds.merge(point);
        mSquaredRadius = std::max(mSquaredRadius, point.squaredLength());
    }

    Error notFinite(unsigned vertex) const
    {
        Error error{ErrorCode::InvalidGeometry, "the position is not finite"};
        error.subMesh = static_cast<int>(mReport.subMeshes);
        error.item = vertex;
        return error;
    }

    const aiScene& mScene;
    Ogre::Mesh& mMesh;
    ImportReport& mReport;
    Ogre::AxisAlignedBox mBounds;
    Ogre::Real mSquaredRadius = 0.0f;
};

std::size_t countBones(const aiScene& scene)
{
    std::size_t bones = 0;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i)
        bones += scene.mMeshes[i]->mNumBones;
    return bones;
}

std::size_t countMorphTargets(const aiScene& scene)
{
    std::size_t targets = 0;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i)
        targets += scene.mMeshes[i]->mNumAnimMeshes;
    return targets;
}

void noteLeftOut(const aiScene& scene, std::vector<std::string>& notes)
{
    const auto note = [&](std::size_t count, const char* what) {
        if (count > 0)
            notes.push_back(std::to_string(count) + " " + what + " left out");
    };
    note(countBones(scene), "bones of skinned meshes");
    note(countMorphTargets(scene), "morph targets");
    note(scene.mNumAnimations, "animations");
    note(scene.mNumTextures, "embedded textures");
}

void noteUnit(const aiScene& scene, std::vector<std::string>& notes)
{
    double centimetres = 0.0;
    float inFloat = 0.0f;
    if (!scene.mMetaData)
        return;
    if (scene.mMetaData->Get("UnitScaleFactor", inFloat))
        centimetres = static_cast<double>(inFloat);
    else if (!scene.mMetaData->Get("UnitScaleFactor", centimetres))
        return;
    notes.push_back("one unit is " + formatNumber(centimetres, 6) + " cm in the file; positions are kept as they are");
}

} // namespace

Result<ImportReport> importModel(const fs::path& path, Ogre::Mesh& mesh)
{
    if (auto readable = checkReadable(path); !readable)
        return readable.error();
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kHardEdgeDegrees);
    const aiScene* scene = importer.ReadFile(
        path.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals
                           | aiProcess_JoinIdenticalVertices | aiProcess_FlipUVs | aiProcess_ValidateDataStructure);
    if (!scene || !scene->mRootNode)
        return fail(ErrorCode::BadFile, std::string("cannot be imported: ") + importer.GetErrorString(), path);

    ImportReport report;
    MeshBuilder builder(*scene, mesh, report);
    if (auto added = builder.addNode(*scene->mRootNode, aiMatrix4x4()); !added) {
        Error error = added.error();
        error.file = path.string();
        return error;
    }
    if (report.triangles == 0)
        return fail(ErrorCode::Unsupported, "holds no triangles", path);
    builder.finish();
    noteLeftOut(*scene, report.notes);
    noteUnit(*scene, report.notes);
    return report;
}

} // namespace lodsmith::cli
