#include "viewer/render/growing_buffer.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "viewer/render/gl_test.h"

namespace kerf::test {

namespace {

class GrowingBufferTest : public GlTest
{
};

std::vector<std::uint8_t> content_of(const render::GrowingBuffer& buffer, std::size_t size)
{
    std::vector<std::uint8_t> bytes(size);
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(size), bytes.data());
    return bytes;
}

}  // namespace

TEST_F(GrowingBufferTest, HoldsWhatWasAppendedPieceByPiece)
{
    std::vector<std::uint8_t> expected(5000);
    std::iota(expected.begin(), expected.end(), std::uint8_t{1});
    render::GrowingBuffer buffer(16);
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

TEST_F(GrowingBufferTest, StaysWhereItIsWhileThereIsRoom)
{
    render::GrowingBuffer buffer(100);
    const GLuint id = buffer.id();
    const std::vector<std::byte> bytes(50);
    EXPECT_FALSE(buffer.write(0, bytes));
    EXPECT_FALSE(buffer.write(50, bytes));
    EXPECT_EQ(buffer.id(), id);
    EXPECT_EQ(buffer.bytes_copied(), 0u);
}

TEST_F(GrowingBufferTest, TakesNothingAtAll)
{
    render::GrowingBuffer buffer(0);
    EXPECT_FALSE(buffer.write(0, {}));
    const std::vector<std::byte> bytes(3);
    EXPECT_TRUE(buffer.write(0, bytes));
}

}  // namespace kerf::test
