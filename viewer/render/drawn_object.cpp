#include "viewer/render/drawn_object.h"

namespace kerf::render {

void cull_for(const DrawnObject& object)
{
    const auto set = [](GLenum what, bool on) { on ? glEnable(what) : glDisable(what); };
    // What is seen of an open mesh's back is drawn, too.
    set(GL_CULL_FACE, object.is_closed);
    set(GL_CLIP_DISTANCE0, object.is_clipped);
}

void end_culling()
{
    glDisable(GL_CULL_FACE);
    glDisable(GL_CLIP_DISTANCE0);
}

void draw_runs(const IndexRuns& runs, DrawStatistics& statistics)
{
    glMultiDrawElements(GL_TRIANGLES, runs.counts.data(), GL_UNSIGNED_INT, runs.offsets.data(),
                        static_cast<GLsizei>(runs.counts.size()));
    ++statistics.calls;
    statistics.ranges += runs.counts.size();
}

}  // namespace kerf::render
