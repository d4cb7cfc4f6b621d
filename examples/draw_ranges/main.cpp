// draw_ranges: what goes to the GPU after a cut, and what is drawn, with plain OpenGL 3.3. Both halves of a torus share one
// vertex and one index buffer; the cut adds to them, and only that is uploaded.

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <kerf/kerf.h>
#include <kerf/shapes.h>

#include <cstdio>
#include <map>
#include <vector>

namespace {

constexpr int kSize = 400;

/// The copies on the GPU of a set of buffers, by their serial number: objects with equal numbers share them.
struct GpuBuffers
{
    GLuint array = 0, vertices = 0, indices = 0;
    std::size_t vertex_room = 0, index_room = 0;  // bytes
};

class Gpu
{
public:
    /// Uploads what is new of a view, and says how many bytes that were.
    std::size_t upload(const kerf::DrawView& view)
    {
        GpuBuffers& buffers = buffers_[view.buffers];
        if (buffers.array == 0) {
            glGenVertexArrays(1, &buffers.array);
            glGenBuffers(1, &buffers.vertices);
            glGenBuffers(1, &buffers.indices);
        }
        glBindVertexArray(buffers.array);
        std::size_t bytes = put(GL_ARRAY_BUFFER, buffers.vertices, buffers.vertex_room, std::as_bytes(view.vertices),
                                view.new_vertices_from * sizeof(kerf::DrawVertex));
        bytes += put(GL_ELEMENT_ARRAY_BUFFER, buffers.indices, buffers.index_room, std::as_bytes(view.indices),
                     view.new_indices_from * sizeof(std::uint32_t));
        for (GLuint attribute = 0; attribute < 2; ++attribute) {  // position, normal
            glEnableVertexAttribArray(attribute);
            glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(kerf::DrawVertex),
                                  reinterpret_cast<const void*>(attribute * sizeof(kerf::Vec3f)));
        }
        return bytes;
    }

    void draw(const kerf::DrawView& view, GLint shift, float offset, GLint colour)
    {
        glBindVertexArray(buffers_[view.buffers].array);
        glUniform1f(shift, offset);
        for (const kerf::DrawRange& range : view.ranges) {
            const bool is_cap = range.kind == kerf::TriangleKind::cap;
            glUniform3f(colour, is_cap ? 0.95f : 0.25f, is_cap ? 0.55f : 0.55f, is_cap ? 0.2f : 0.8f);
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(range.index_count), GL_UNSIGNED_INT,
                           reinterpret_cast<const void*>(sizeof(std::uint32_t) * std::size_t{range.first_index}));
        }
    }

    /// What Kerf calls when buffers are gone: their copies may go, too.
    static void release(void* gpu, std::uint64_t buffers)
    {
        auto& all = static_cast<Gpu*>(gpu)->buffers_;
        if (const auto found = all.find(buffers); found != all.end()) {
            glDeleteBuffers(1, &found->second.vertices);
            glDeleteBuffers(1, &found->second.indices);
            glDeleteVertexArrays(1, &found->second.array);
            all.erase(found);
        }
    }

    std::size_t count() const { return buffers_.size(); }

private:
    /// Everything goes up anew if there is not enough room; a cut finds room for itself.
    static std::size_t put(GLenum target, GLuint buffer, std::size_t& room, std::span<const std::byte> bytes,
                           std::size_t from)
    {
        glBindBuffer(target, buffer);
        if (room < bytes.size()) {
            room = 2 * bytes.size();
            glBufferData(target, static_cast<GLsizeiptr>(room), nullptr, GL_STATIC_DRAW);
            from = 0;
        }
        glBufferSubData(target, static_cast<GLintptr>(from), static_cast<GLsizeiptr>(bytes.size() - from),
                        bytes.data() + from);
        return bytes.size() - from;
    }

    std::map<std::uint64_t, GpuBuffers> buffers_;
};

GLuint program()
{
    const char* const sources[2] = {
        "#version 330 core\nlayout(location = 0) in vec3 position; layout(location = 1) in vec3 normal;"
        "uniform float shift; out vec3 n;"
        "void main() { n = normal; vec3 p = position + vec3(0, shift, 0);"
        " gl_Position = vec4(0.55 * p.x, 0.55 * (0.8 * p.y + 0.6 * p.z), 0.3 * (0.6 * p.y - 0.8 * p.z), 1); }",
        "#version 330 core\nin vec3 n; uniform vec3 colour; out vec4 o;"
        "void main() { o = vec4(colour * (0.3 + 0.7 * abs(dot(normalize(n), normalize(vec3(0.3, 0.7, 0.6))))), 1); }"};
    const GLuint linked = glCreateProgram();
    for (int i = 0; i < 2; ++i) {
        const GLuint shader = glCreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
        glShaderSource(shader, 1, &sources[i], nullptr);
        glCompileShader(shader);
        glAttachShader(linked, shader);
    }
    glLinkProgram(linked);
    return linked;
}

/// Pixels that are not background; writes the picture as PPM.
int drawn_pixels()
{
    std::vector<unsigned char> rgb(3u * kSize * kSize);
    glReadPixels(0, 0, kSize, kSize, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    int pixels = 0;
    for (std::size_t i = 0; i < rgb.size(); i += 3) pixels += rgb[i] + rgb[i + 1] + rgb[i + 2] > 0 ? 1 : 0;
    if (std::FILE* const file = std::fopen("halves.ppm", "wb")) {
        std::fprintf(file, "P6\n%d %d\n255\n", kSize, kSize);
        for (int row = kSize - 1; row >= 0; --row)
            std::fwrite(&rgb[3u * kSize * static_cast<unsigned>(row)], 3, kSize, file);
        std::fclose(file);
    }
    return pixels;
}

int run()
{
    Gpu gpu;
    const GLuint shaders = program();
    glUseProgram(shaders);
    const GLint shift = glGetUniformLocation(shaders, "shift"), colour = glGetUniformLocation(shaders, "colour");
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    {
        kerf::PrepareOptions options;
        options.back_end = kerf::BackEnd::halfedge;  // whose pieces share buffers
        options.listener = {&Gpu::release, &gpu};
        const kerf::Result<kerf::Mesh> torus = kerf::make_shape("torus", 20'000);
        kerf::Result<kerf::Object> whole = kerf::prepare(*torus, options);
        if (!whole) return std::fprintf(stderr, "%s\n", whole.reason()), 1;

        kerf::DrawView view;
        if (whole->draw(view) != kerf::Status::done) return 1;
        const std::size_t all = gpu.upload(view);
        whole->mark_uploaded(view);

        kerf::Cut cut = kerf::cut(*std::move(whole), *kerf::Plane::y(0.1));
        std::size_t news = 0;
        for (const kerf::Side side : {kerf::Side::positive, kerf::Side::negative}) {
            kerf::Object* const half = cut.one(side);
            if (half == nullptr || half->draw(view) != kerf::Status::done) return 1;
            news += gpu.upload(view);
            half->mark_uploaded(view);
            gpu.draw(view, shift, side == kerf::Side::positive ? 0.35f : -0.35f, colour);
        }
        std::printf("%zu bytes for the torus, %zu more for its cut; %d pixels\n", all, news, drawn_pixels());
        if (news == 0 || news > all / 4) return 1;
    }
    std::printf("%zu buffers are left\n", gpu.count());
    return gpu.count() == 0 && glGetError() == GL_NO_ERROR ? 0 : 1;
}

}  // namespace

int main()
{
    if (glfwInit() == 0) return std::fprintf(stderr, "there is no display\n"), 1;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* const window = glfwCreateWindow(kSize, kSize, "draw_ranges", nullptr, nullptr);
    if (window == nullptr) return std::fprintf(stderr, "there is no OpenGL 3.3\n"), 1;
    glfwMakeContextCurrent(window);
    const int status = run();
    glfwTerminate();
    return status;
}
