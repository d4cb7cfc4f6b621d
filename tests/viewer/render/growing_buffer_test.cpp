#include "viewer/render/growing_buffer.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "viewer/render/gl_test.h"

namespace kerf::test {

namespace {

class MappingTest : public GlTest
{
protected:
    void SetUp() override
    {
        if (render::mapping_for(1) != render::Mapping::kept) GTEST_SKIP() << "this driver keeps no buffer mapped";
    }
};

class GrowingBufferTest : public MappingTest, public testing::WithParamInterface<render::Mapping>
{
};

INSTANTIATE_TEST_SUITE_P(Mappings, GrowingBufferTest,
                         testing::Values(render::Mapping::kept, render::Mapping::each_write), [](const auto& mapping) {
                             return std::string(mapping.param == render::Mapping::kept ? "kept" : "each_write");
                         });

std::vector<std::uint8_t> content_of(const render::GrowingBuffer& buffer, std::size_t size)
{
    std::vector<std::uint8_t> bytes(size);
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(size), bytes.data());
    return bytes;
}

}  // namespace

TEST_P(GrowingBufferTest, HoldsWhatWasAppendedPieceByPiece)
{
    std::vector<std::uint8_t> expected(5000);
    std::iota(expected.begin(), expected.end(), std::uint8_t{1});
    render::GrowingBuffer buffer(16, GetParam());
    int moves = 0;
    for (std::size_t at = 0, size = 1; at < expected.size(); at += size, size = size * 2 + 1) {
        size = std::min(size, expected.size() - at);
        moves += buffer.write(at, std::as_bytes(std::span(expected).subspan(at, size))) ? 1 : 0;
    }
    EXPECT_EQ(content_of(buffer, expected.size()), expected);
    EXPECT_GT(moves, 2);
    EXPECT_LT(moves, 12);
    EXPECT_LE(buffer.capacity(), 2 * expected.size());
    // Doubling copies each byte less than twice altogether.
    EXPECT_LT(buffer.bytes_copied(), 2 * expected.size());
}

TEST_P(GrowingBufferTest, StaysWhereItIsWhileThereIsRoom)
{
    render::GrowingBuffer buffer(100, GetParam());
    const GLuint id = buffer.id();
    const std::vector<std::byte> bytes(50);
    EXPECT_FALSE(buffer.write(0, bytes));
    EXPECT_FALSE(buffer.write(50, bytes));
    EXPECT_EQ(buffer.id(), id);
    EXPECT_EQ(buffer.bytes_copied(), 0u);
}

TEST_P(GrowingBufferTest, TakesNothingAtAll)
{
    render::GrowingBuffer buffer(0, GetParam());
    EXPECT_FALSE(buffer.write(0, {}));
    const std::vector<std::byte> bytes(3);
    EXPECT_TRUE(buffer.write(0, bytes));
}

TEST_P(GrowingBufferTest, IsWrittenWithoutTheDriverIfItStaysMapped)
{
    render::GrowingBuffer buffer(100, GetParam());
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.id());
    GLint is_mapped = GL_FALSE;
    glGetBufferParameteriv(GL_COPY_WRITE_BUFFER, GL_BUFFER_MAPPED, &is_mapped);
    EXPECT_EQ(is_mapped == GL_TRUE, GetParam() == render::Mapping::kept);
}

TEST_F(MappingTest, MapsLargeBuffersForEachWrite)
{
    EXPECT_EQ(render::mapping_for(render::kMostKeptMapped), render::Mapping::kept);
    EXPECT_EQ(render::mapping_for(render::kMostKeptMapped + 1), render::Mapping::each_write);
}

}  // namespace kerf::test
