#!/usr/bin/env python3
# %% [markdown]
# # Cutting a mesh, and drawing what comes of it
#
# Run it as a script, with a folder for the pictures, or cell by cell in an editor that knows `# %%`.

# %%
import sys
from pathlib import Path

import kerf
import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import PathPatch
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

FOLDER = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
FOLDER.mkdir(parents=True, exist_ok=True)
STONE, FLESH, INK = (matplotlib.colors.to_rgb(name) for name in ("#b9a58a", "#d2553f", "#3c3733"))
LIGHT = np.array([0.40, -0.70, 0.59])


def draw(axes, mesh, shift=(0.0, 0.0, 0.0), colours=None):
    """The triangles of a mesh, darker where they are turned from the light; caps are red."""
    if colours is None:
        colours = np.where(mesh.is_cap[:, None], FLESH, STONE)
    corners = mesh.vertices[mesh.faces] + np.asarray(shift)
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    across /= np.maximum(np.linalg.norm(across, axis=1), 1e-12)[:, None]
    bright = 0.45 + 0.55 * np.clip(across @ LIGHT, 0, 1)
    shaded = colours * bright[:, None]
    # Edges in the colours of their triangles leave no gaps between these.
    axes.add_collection3d(Poly3DCollection(corners, facecolors=shaded, edgecolors=shaded, linewidths=0.4))


def stage(low, high, title, size=(6, 4.5)):
    """A figure, and axes that show this part of space and nothing of themselves."""
    figure = plt.figure(figsize=size)
    axes = figure.add_axes((0, 0, 1, 0.92), projection="3d")
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set_box_aspect(np.subtract(high, low), zoom=1.45)
    axes.view_init(elev=22, azim=-60)
    axes.set_axis_off()
    figure.suptitle(title, y=0.97)
    return figure, axes


def save(figure, name):
    figure.savefig(FOLDER / name, dpi=110, facecolor="white")
    plt.close(figure)
    print(FOLDER / name)


# %% [markdown]
# ## Both halves, in one call

# %%
torus = kerf.shape("torus", 6000)
cut = kerf.cut(torus, origin=(0, 0, 0), normal=(0.25, 1, 0.35))
print(torus, cut, cut.positive, cut.negative, sep="\n")

figure, axes = stage((-1.4, -1.5, -0.5), (1.6, 2.6, 0.9), "A torus and a plane: both halves are closed", (7, 4))
draw(axes, cut.negative)
draw(axes, cut.positive, shift=(0.25, 1.0, 0.35))
save(figure, "halves.png")

# %% [markdown]
# ## Attributes go along
# What is known at the vertices is known at the vertices of the pieces, also where edges were cut: here how far up they are.

# %%
rock = kerf.shape("asteroid", 20_000, seed=4)
rock = kerf.Mesh(rock.vertices, rock.faces, attributes={"height": rock.vertices[:, 2]})
half = kerf.cut(rock, origin=(0, 0, 0), normal=(0.7, 1, -0.15)).positive
height = half.attributes["height"][half.faces].mean(axis=1)
bands = plt.get_cmap("viridis")(np.floor(8 * (height - height.min()) / np.ptp(height)) / 8)[:, :3]

figure, axes = stage(*rock.bounds, "An attribute of the surface, and the cap")
draw(axes, half, colours=np.where(half.is_cap[:, None], FLESH, bands))
save(figure, "attributes.png")

# %% [markdown]
# ## What a plane meets, and where its holes are
# A sponge, cut straight, aslant, and across a diagonal.

# %%
sponge = kerf.shape("menger_sponge", 20_000)
figure, all_axes = plt.subplots(1, 3, figsize=(9, 3.4))
for axes, normal in zip(all_axes, ((0, 0, 1), (1, 2, 3), (1, 1, 1))):
    section = kerf.section(sponge, origin=sponge.bounds.mean(axis=0) + (0.01, 0.01, 0.01), normal=normal)
    for outer, holes in section.polygons():
        loops = [matplotlib.path.Path(np.vstack([loop, loop[:1]]), closed=True) for loop in [outer, *holes]]
        together = matplotlib.path.Path.make_compound_path(*loops)
        axes.add_patch(PathPatch(together, facecolor=FLESH, edgecolor=INK, linewidth=0.6))
    axes.autoscale_view()
    axes.set(aspect="equal")
    axes.set_title(f"normal {normal}: {len(section.loops)} loops", fontsize=10)
    axes.set_axis_off()
figure.tight_layout()
save(figure, "sections.png")

# %% [markdown]
# ## A stack of sections: contour lines, and a volume

# %%
heights = np.linspace(*rock.bounds[:, 2], 41)[1:-1]
stack = kerf.sections(rock, normal="z", heights=heights)
print("volume", round(rock.volume, 4), "by its sections", round(np.trapz([layer.area for layer in stack], heights), 4))

figure, axes = plt.subplots(figsize=(5, 5))
for height, section in zip(heights, stack):
    for loop in section.loops:
        around = np.vstack([loop, loop[:1]])
        axes.plot(around[:, 0], around[:, 1], linewidth=0.9, color=plt.get_cmap("viridis")((height - heights[0]) / np.ptp(heights)))
axes.set(aspect="equal", title="39 sections of a rock, seen from above")
axes.set_axis_off()
save(figure, "contours.png")

# %% [markdown]
# ## Dice

# %%
pieces = kerf.dice(kerf.shape("asteroid", 5000, seed=4), x=[-0.3, 0.3], y=[-0.3, 0.3], z=[0.0])
print(pieces, "that together have", round(sum(piece.mesh.volume for piece in pieces), 4))

figure, axes = stage((-1.7, -1.7, -1.4), (1.7, 1.7, 1.4), "Eighteen pieces, moved apart")
for mesh, cell in pieces:
    draw(axes, mesh, shift=0.5 * (np.array(cell) - (1, 1, 0.5)))
save(figure, "dice.png")
