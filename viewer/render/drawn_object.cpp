#include "viewer/render/drawn_object.h"

namespace kerf::render {

void cull_for(const DrawnObject& object)
{
    // What is seen of an open mesh's back is drawn, too.
    if (object.is_closed)
        glEnable(GL_CULL_FACE);
    else
        glDisable(GL_CULL_FACE);
}

void draw_runs(const IndexRuns& runs, DrawStatistics& statistics)
{
    glMultiDrawElements(GL_TRIANGLES, runs.counts.data(), GL_UNSIGNED_INT, runs.offsets.data(),
                        static_cast<GLsizei>(runs.counts.size()));
    ++statistics.calls;
    statistics.ranges += runs.counts.size();
}

}  // namespace kerf::render
