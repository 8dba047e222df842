"""The layers of the free fields beside the sides of the domain: where they are another ground, colours do not meet."""

from matplotlib.patches import Rectangle

from tremolo import style

NO_SOIL = "#FFFFFF"  # a layer with constants of its own, and the half-space


def draw(ax, run, low, high):
    """A strip at each side with a free field of layers, from its surface to the base of the domain.

    low, high: the corners of the domain, m. Returns the patches."""
    names = list(run.attribute("soil_names") or [])
    width = high[0] - low[0]
    near, far = 0.008 * width, 0.045 * width
    patches = []
    for side, layers in run.plan.get("free_field", {}).items():
        left = low[0] - far if side == "left" else high[0] + near
        for layer in layers:
            bottom = max(layer["bottom_m"], low[1])
            if layer["top_m"] <= bottom:
                continue
            name = layer["soil"]
            known = name in names
            colour = style.SOIL_COLOURS[names.index(name) % len(style.SOIL_COLOURS)] if known else NO_SOIL
            patch = Rectangle((left, bottom), far - near, layer["top_m"] - bottom, facecolor=colour, edgecolor="#333333",
                              linewidth=0.4, hatch=None if known else "///", label=name or "elastic layer")
            patches.append(ax.add_patch(patch))
    return patches
