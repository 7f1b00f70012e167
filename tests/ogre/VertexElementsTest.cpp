#include <support/OgreSession.h>

#include <lodsmith/ogre/MeshReader.h>

#include <OgreHardwareBufferManager.h>
#include <OgreMeshManager.h>
#include <OgreSubMesh.h>
#include <support/OgreMeshBuilder.h>

#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::FloatEq;
using Bytes = std::vector<unsigned char>;

template <class T>
Bytes bytesOf(std::initializer_list<T> values)
{
    Bytes bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.begin(), bytes.size());
    return bytes;
}

/// One vertex element of every vertex, and what its three vertices hold.
struct Element {
    Ogre::VertexElementSemantic semantic;
    Ogre::VertexElementType type;
    Bytes vertex; ///< the same for each vertex
};

class VertexElementsTest : public testing::Test {
protected:
    /// A triangle with these elements; what has no position gets one of float3. Each vertex is followed by `gap` bytes.
    MeshData read(std::vector<Element> elements, std::size_t gap = 0)
    {
        if (elements[0].semantic != Ogre::VES_POSITION)
            elements.insert(elements.begin(), {Ogre::VES_POSITION, Ogre::VET_FLOAT3, bytesOf<float>({0, 0, 0})});
        mMesh = Ogre::MeshManager::getSingleton().createManual("mesh" + std::to_string(mCount++), "General");
        Ogre::SubMesh* subMesh = mMesh->createSubMesh();
        subMesh->useSharedVertices = false;
        subMesh->vertexData = OGRE_NEW Ogre::VertexData();
        subMesh->vertexData->vertexCount = 3;
        Bytes vertex;
        for (const Element& element : elements) {
            EXPECT_EQ(element.vertex.size(), Ogre::VertexElement::getTypeSize(element.type));
            subMesh->vertexData->vertexDeclaration->addElement(0, vertex.size(), element.type, element.semantic);
            vertex.insert(vertex.end(), element.vertex.begin(), element.vertex.end());
        }
        vertex.resize(vertex.size() + gap, 0xEE);
        auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
            vertex.size(), 3, Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
        for (std::size_t i = 0; i < 3; ++i)
            buffer->writeData(i * vertex.size(), vertex.size(), vertex.data());
        subMesh->vertexData->vertexBufferBinding->setBinding(0, buffer);
        setIndices(*subMesh, {0, 1, 2}, Ogre::RenderOperation::OT_TRIANGLE_LIST);
        mMesh->load();
        auto data = MeshReader::read(*mMesh);
        EXPECT_TRUE(data);
        return std::move(data).value();
    }

    /// What the reader makes of the last vertex.
    std::vector<float> position(Ogre::VertexElementType type, const Bytes& bytes)
    {
        const MeshData data = read({{Ogre::VES_POSITION, type, bytes}});
        return last(data.view().vertexBuffers[0].positions, 3);
    }

    std::vector<float> colour(Ogre::VertexElementType type, const Bytes& bytes)
    {
        const MeshData data = read({{Ogre::VES_COLOUR, type, bytes}});
        return last(data.view().vertexBuffers[0].colours, 4);
    }

    static std::vector<float> last(const FloatStream& stream, int components)
    {
        std::vector<float> values(static_cast<std::size_t>(components));
        EXPECT_TRUE(stream);
        if (stream)
            stream.read(2, components, values.data());
        return values;
    }

    OgreSession mSession;
    Ogre::MeshPtr mMesh;
    int mCount = 0;
};

TEST_F(VertexElementsTest, FloatsAreCopied)
{
    EXPECT_THAT(position(Ogre::VET_FLOAT3, bytesOf<float>({1.5f, -2.5f, 3e30f})), ElementsAre(1.5f, -2.5f, 3e30f));
}

TEST_F(VertexElementsTest, NonFiniteFloatsAreCopiedForTheCoreToFind)
{
    const auto values = position(Ogre::VET_FLOAT3, bytesOf<float>({NAN, INFINITY, 0.0f}));
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_TRUE(std::isinf(values[1]));
}

TEST_F(VertexElementsTest, ComponentsBeyondThreeAreDropped)
{
    EXPECT_THAT(position(Ogre::VET_FLOAT4, bytesOf<float>({1, 2, 3, 4})), ElementsAre(1, 2, 3));
    EXPECT_THAT(position(Ogre::VET_DOUBLE4, bytesOf<double>({1, 2, 3, 4})), ElementsAre(1, 2, 3));
}

TEST_F(VertexElementsTest, MissingComponentsAreZero)
{
    EXPECT_THAT(position(Ogre::VET_FLOAT1, bytesOf<float>({7})), ElementsAre(7, 0, 0));
    EXPECT_THAT(position(Ogre::VET_FLOAT2, bytesOf<float>({7, 8})), ElementsAre(7, 8, 0));
    EXPECT_THAT(position(Ogre::VET_SHORT2, bytesOf<std::int16_t>({7, -8})), ElementsAre(7, -8, 0));
}

TEST_F(VertexElementsTest, DoublesAreRounded)
{
    EXPECT_THAT(position(Ogre::VET_DOUBLE3, bytesOf<double>({0.1, -0.2, 1e10})), ElementsAre(0.1f, -0.2f, 1e10f));
}

TEST_F(VertexElementsTest, WholeNumbersKeepTheirValue)
{
    EXPECT_THAT(position(Ogre::VET_SHORT4, bytesOf<std::int16_t>({-32768, 32767, -1, 9})),
                ElementsAre(-32768, 32767, -1));
    EXPECT_THAT(position(Ogre::VET_SHORT3, bytesOf<std::int16_t>({-32768, 32767, -1})), ElementsAre(-32768, 32767, -1));
    EXPECT_THAT(position(Ogre::VET_USHORT4, bytesOf<std::uint16_t>({65535, 1, 2, 9})), ElementsAre(65535, 1, 2));
    EXPECT_THAT(position(Ogre::VET_INT3, bytesOf<std::int32_t>({-70000, 70000, 3})), ElementsAre(-70000, 70000, 3));
    EXPECT_THAT(position(Ogre::VET_UINT4, bytesOf<std::uint32_t>({4000000000u, 1, 2, 9})),
                ElementsAre(4000000000.0f, 1, 2));
    EXPECT_THAT(position(Ogre::VET_BYTE4, bytesOf<std::int8_t>({-128, 127, 0, 9})), ElementsAre(-128, 127, 0));
    EXPECT_THAT(position(Ogre::VET_UBYTE4, bytesOf<std::uint8_t>({255, 1, 2, 9})), ElementsAre(255, 1, 2));
}

TEST_F(VertexElementsTest, NormalisedNumbersReachExactlyOne)
{
    EXPECT_THAT(position(Ogre::VET_SHORT4_NORM, bytesOf<std::int16_t>({32767, -32768, -32767, 0})),
                ElementsAre(1, -1, -1));
    EXPECT_THAT(position(Ogre::VET_USHORT4_NORM, bytesOf<std::uint16_t>({65535, 0, 13107, 0})),
                ElementsAre(1, 0, FloatEq(0.2f)));
    EXPECT_THAT(position(Ogre::VET_BYTE4_NORM, bytesOf<std::int8_t>({127, -128, -127, 0})), ElementsAre(1, -1, -1));
    EXPECT_THAT(position(Ogre::VET_UBYTE4_NORM, bytesOf<std::uint8_t>({255, 0, 51, 0})),
                ElementsAre(1, 0, FloatEq(0.2f)));
}

TEST_F(VertexElementsTest, PackedColoursBecomeRedGreenBlueAlpha)
{
    const auto isColour = ElementsAre(FloatEq(1.0f), FloatEq(0.8f), FloatEq(0.6f), FloatEq(0.4f));
    EXPECT_THAT(colour(Ogre::VET_COLOUR_ARGB, bytesOf<std::uint32_t>({0x66FFCC99u})), isColour);
    EXPECT_THAT(colour(Ogre::VET_COLOUR_ABGR, bytesOf<std::uint32_t>({0x6699CCFFu})), isColour);
    EXPECT_THAT(colour(Ogre::VET_UBYTE4_NORM, bytesOf<std::uint8_t>({0xFF, 0xCC, 0x99, 0x66})), isColour);
    EXPECT_THAT(colour(Ogre::VET_UBYTE4, bytesOf<std::uint8_t>({0xFF, 0xCC, 0x99, 0x66})), isColour);
}

TEST_F(VertexElementsTest, PackedColoursAgreeWithOgre)
{
    const Ogre::ColourValue colourValue(0.2f, 0.4f, 0.6f, 0.8f);
    for (const auto type : {Ogre::VET_COLOUR, Ogre::VET_COLOUR_ARGB, Ogre::VET_COLOUR_ABGR}) {
        const auto native = type == Ogre::VET_COLOUR ? Ogre::VertexElement::getBestColourVertexElementType() : type;
        const Ogre::uint32 packed = Ogre::VertexElement::convertColourValue(colourValue, native);
        EXPECT_THAT(colour(type, bytesOf<std::uint32_t>({packed})),
                    ElementsAre(FloatEq(0.2f), FloatEq(0.4f), FloatEq(0.6f), FloatEq(0.8f)))
            << "type " << type;
    }
}

TEST_F(VertexElementsTest, ColoursWithoutAlphaAreOpaque)
{
    EXPECT_THAT(colour(Ogre::VET_FLOAT3, bytesOf<float>({0.25f, 0.5f, 0.75f})), ElementsAre(0.25f, 0.5f, 0.75f, 1.0f));
    EXPECT_THAT(colour(Ogre::VET_FLOAT4, bytesOf<float>({0.25f, 0.5f, 0.75f, 0.0f})),
                ElementsAre(0.25f, 0.5f, 0.75f, 0.0f));
}

TEST_F(VertexElementsTest, TextureCoordinatesKeepTheirComponents)
{
    const MeshData three =
        read({{Ogre::VES_TEXTURE_COORDINATES, Ogre::VET_FLOAT3, bytesOf<float>({0.1f, 0.2f, 0.3f})}});
    ASSERT_EQ(three.view().vertexBuffers[0].uvSets.size(), 1u);
    EXPECT_EQ(three.view().vertexBuffers[0].uvSets[0].components, 3);
    EXPECT_THAT(last(three.view().vertexBuffers[0].uvSets[0].stream, 3), ElementsAre(0.1f, 0.2f, 0.3f));
    const MeshData shorts =
        read({{Ogre::VES_TEXTURE_COORDINATES, Ogre::VET_USHORT2_NORM, bytesOf<std::uint16_t>({65535, 0})}});
    EXPECT_EQ(shorts.view().vertexBuffers[0].uvSets[0].components, 2);
    EXPECT_THAT(last(shorts.view().vertexBuffers[0].uvSets[0].stream, 2), ElementsAre(1, 0));
}

TEST_F(VertexElementsTest, InterleavedElementsAndOddStridesAreKeptApart)
{
    const MeshData data = read({{Ogre::VES_POSITION, Ogre::VET_FLOAT3, bytesOf<float>({1, 2, 3})},
                                {Ogre::VES_NORMAL, Ogre::VET_BYTE4_NORM, bytesOf<std::int8_t>({0, 0, 127, 0})},
                                {Ogre::VES_COLOUR, Ogre::VET_COLOUR_ABGR, bytesOf<std::uint32_t>({0xFF0000FFu})},
                                {Ogre::VES_TEXTURE_COORDINATES, Ogre::VET_FLOAT2, bytesOf<float>({0.5f, 0.25f})}},
                               3);
    const VertexBufferView& view = data.view().vertexBuffers[0];
    EXPECT_THAT(last(view.positions, 3), ElementsAre(1, 2, 3));
    EXPECT_THAT(last(view.normals, 3), ElementsAre(0, 0, 1));
    EXPECT_THAT(last(view.colours, 4), ElementsAre(1, 0, 0, 1));
    EXPECT_THAT(last(view.uvSets[0].stream, 2), ElementsAre(0.5f, 0.25f));
}

TEST_F(VertexElementsTest, UnknownTypesAreNotedAndNotRead)
{
    const auto unknown = static_cast<Ogre::VertexElementType>(63);
    mMesh = makeOgreMesh("mesh", makeGrid(1, 1));
    auto* declaration = mMesh->getSubMesh(0)->vertexData->vertexDeclaration;
    declaration->modifyElement(1, 0, 12, unknown, Ogre::VES_NORMAL);
    const auto data = MeshReader::read(*mMesh);
    ASSERT_TRUE(data);
    EXPECT_FALSE(data.value().view().vertexBuffers[0].normals);
    EXPECT_THAT(data.value().notes(), ElementsAre(testing::HasSubstr("unknown type 63")));
    declaration->modifyElement(0, 0, 0, unknown, Ogre::VES_POSITION);
    const auto refused = MeshReader::read(*mMesh);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Unsupported);
}

} // namespace
} // namespace lodsmith::test
