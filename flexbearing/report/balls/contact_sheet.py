"""Maps of contacts on one sheet: pressure, shear stress, slip, stick, each on one scale of colours."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from textwrap import wrap
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from flexbearing.printable import printable
from flexbearing.quantities.reductions import RACES
from flexbearing.report.balls.contact_fields import DrawnBall, DrawnContact, Place, friction_of
from flexbearing.report.picture import NUMBERS, titled
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# [in], placed by hand: contacts are drawn to scale, so that no layout may stretch them
LEFT, PANEL, GAP, RIGHT = 1.15, 4.4, 0.3, 0.2
TALLEST, FLATTEST = 2.6, 0.4  # panels
LINE, CAPTION, TICKS, BETWEEN, BAR = 0.19, 0.26, 0.3, 0.07, 0.13
ROOM, HIGH = 1.06, 1.12  # of a panel around the ellipse, across and along
ARROW, ACROSS, ALONG = 0.13, 0.24, 0.16  # length and distances of arrows [in]
WIDEST = 155  # letters of a note in a line
STICK, SLIP = "#0072B2", "#F0C987"  # distinguished by colour-blind readers, and in grey
AXES = "to the right: across the groove; upwards: rolling direction, towards growing azimuth [mm]"


class Map(NamedTuple):
    """What is drawn of every contact."""

    name: str
    values: Callable[[DrawnContact], np.ndarray]  # (n, m) in the unit for people
    label: str = ""  # of the scale of colours; stick and slip have a legend
    colours: str = ""
    power: float = 1.0  # of the scale: below one, small values are reported apart
    arrows: bool = False


PRESSURE = Map("pressure", lambda contact: 1e-6 * contact.pressure, "pressure [MPa]", "Blues")
SHEAR = Map(
    "shear stress\non the ball",
    lambda contact: 1e-6 * np.hypot(*contact.shear),
    "shear stress [MPa]",
    "YlOrRd",
    arrows=True,
)
SLIDING = Map("slip", lambda contact: 1e3 * np.hypot(*contact.slip), "slip [mm/s]", "viridis_r", power=0.5)
STICKING = Map("stick and slip", lambda contact: contact.stick)


class Column(NamedTuple):
    """What stands side by side, without a title where its contacts say enough."""

    title: str
    below: str  # the title, in plain letters


Group = list[tuple[str, DrawnContact | None]]  # a contact of each column with its title; None without load


def titles(place: Place, contact: DrawnContact | None) -> tuple[str, DrawnContact | None]:
    """A contact with its title: where it is, and what it carries."""
    where = ", ".join(filter(None, place))
    return (where if contact is None else f"{where}: {contact.caption}"), contact


def sheet(
    heading: str, columns: list[Column], groups: list[Group], maps: list[Map], notes: list[str]
) -> Figure:
    """Draw contacts side by side, to scale, with one scale of colours for each map."""
    below = [line for note in notes for line in wrap(printable(note), WIDEST)]
    shapes = [_half_sides(group) for group in groups]
    tops = [len(maps) * (PANEL * high / wide + BETWEEN) + CAPTION + TICKS for wide, high in shapes]
    titles_height = 2.4 * LINE if any(column.title for column in columns) else 0.0
    top_margin = (1.25 * (heading.count("\n") + 1) + 0.8) * LINE
    page = _Page.empty(len(columns), top_margin + titles_height + sum(tops) + (5.2 + len(below)) * LINE)
    page.figure.suptitle(heading, fontsize=11, y=1 - 0.5 * LINE / page.height, va="top", parse_math=False)
    top = page.height - top_margin
    for number, column in enumerate(columns):
        page.text(_middle(number), top, column.title, size=10, weight="bold", ha="center")
        page.text(_middle(number), top - 1.1 * LINE, column.below, size=9, ha="center")
    top -= titles_height
    scales = {each.name: _scale(each, groups) for each in maps}
    for group, shape, used in zip(groups, shapes, tops, strict=True):
        _draw_group(page, group, (top, shape), scales, maps)
        top -= used
    page.text(LEFT, top + 0.3 * LINE, AXES)
    _draw_scales(page, top - 2.2 * LINE, [(each, scales[each.name]) for each in maps])
    for number, line in enumerate(below):
        page.text(0.1, (len(below) - number) * LINE, line)
    return page.figure


def headed(title: str, what: str) -> str:
    """Heading of a sheet: the title of the case in lines, and what is drawn."""
    return f"{titled(title, 90)}\n{what}"


def ball_sheet(result: Result, ball: DrawnBall) -> Figure:
    """Draw the contacts of one ball: inner and outer race side by side, its diagonals below each other."""
    races = [f"{race} race" for race in RACES]
    diagonals = dict.fromkeys(diagonal for diagonal, _ in ball.contacts)
    groups = [
        [titles((diagonal, race), ball.contacts.get((diagonal, race))) for race in races]
        for diagonal in diagonals
    ]
    what = [f"Contacts of ball {ball.number}: {friction_of(result)}", f"{ball.torque}, {ball.cells}"]
    if not groups:
        what[1] = "this ball carries no load"
    columns = [Column("", "") for _ in races]
    heading = headed(result.attributes["title"], "\n".join(what))
    return sheet(heading, columns, groups, [PRESSURE, SHEAR, SLIDING, STICKING], [])


class _Page(NamedTuple):
    """A figure on which everything is placed in inches from its lower left corner."""

    figure: Figure
    width: float
    height: float

    @classmethod
    def empty(cls, columns: int, height: float) -> _Page:
        """A page for some columns of panels."""
        from matplotlib.figure import Figure

        width = LEFT + columns * (PANEL + GAP) - GAP + RIGHT
        return cls(Figure(figsize=(width, height)), width, height)

    def text(self, left: float, top: float, words: str, size: float = 8, **style: Any) -> None:
        """Write words as they are, below a height unless said."""
        place = left / self.width, top / self.height
        self.figure.text(*place, words, fontsize=size, parse_math=False, **{"va": "top", **style})

    def axes(self, left: float, bottom: float, width: float, height: float) -> Axes:
        """Axes in a box."""
        box = left / self.width, bottom / self.height, width / self.width, height / self.height
        return self.figure.add_axes(box)


def _left(column: int) -> float:
    return LEFT + column * (PANEL + GAP)


def _middle(column: int) -> float:
    return _left(column) + PANEL / 2


def _half_sides(group: Group) -> tuple[float, float]:
    """Half width and half height of the panels of a group [mm], as wide as `PANEL` and to scale."""
    extents = [_extent(contact) for _, contact in group if contact is not None]
    across, along = (1e3 * max(sides) for sides in zip(*extents, strict=True))
    wide = max(ROOM * across, HIGH * along * PANEL / TALLEST)
    return wide, max(HIGH * along, wide * FLATTEST / PANEL)


def _extent(contact: DrawnContact) -> tuple[float, float]:
    """Half sides that hold the ellipse and every cell in contact [m]."""
    cells = [float(np.abs(place[contact.touching]).max(initial=0.0)) for place in contact.places]
    return max(contact.semi_axes[0], cells[0]), max(contact.semi_axes[1], cells[1])


def _scale(drawn: Map, groups: list[Group]) -> Any:
    """Colours of a map, the same for all contacts."""
    from matplotlib import colormaps
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import ListedColormap, PowerNorm

    if not drawn.colours:
        return ScalarMappable(PowerNorm(1.0, 0, 1), ListedColormap([SLIP, STICK]))
    contacts = [contact for group in groups for _, contact in group if contact is not None]
    largest = max((float(drawn.values(contact).max()) for contact in contacts), default=0.0)
    return ScalarMappable(PowerNorm(drawn.power, 0, largest or 1.0), colormaps[drawn.colours])


def _draw_group(
    page: _Page,
    group: Group,
    where: tuple[float, tuple[float, float]],
    scales: dict[str, Any],
    maps: list[Map],
) -> None:
    """Contacts side by side, their maps one below the other."""
    top, (wide, high) = where
    side = PANEL * high / wide
    bottoms = [top - CAPTION - (row + 1) * (side + BETWEEN) + BETWEEN for row in range(len(maps))]
    for drawn, bottom in zip(maps, bottoms, strict=True):
        page.text(0.1, bottom + side / 2, drawn.name, va="center")
    for column, (title, contact) in enumerate(group):
        for drawn, bottom in zip(maps, bottoms, strict=True):
            axes = page.axes(_left(column), bottom, PANEL, side)
            axes.set(xlim=(-wide, wide), ylim=(-high, high))
            axes.set_title(title if drawn is maps[0] else "", fontsize=8.5, pad=4)
            _shape(axes, side, last=drawn is maps[-1], first=column == 0)
            if contact is None:
                axes.text(0, 0, "no load", fontsize=8, ha="center", va="center")
            else:
                _draw(axes, contact, drawn, scales[drawn.name])


def _shape(axes: Axes, side: float, *, last: bool, first: bool) -> None:
    from matplotlib.ticker import MaxNLocator

    axes.spines[["top", "right"]].set_visible(False)
    axes.tick_params(labelsize=7, labelbottom=last, labelleft=first, length=2.5, pad=2)
    axes.yaxis.set_major_locator(MaxNLocator(max(2, int(side / 0.22)), steps=[1, 2, 5, 10], symmetric=True))
    axes.xaxis.set_major_locator(MaxNLocator(9, steps=[1, 2, 5, 10]))


def _draw(axes: Axes, contact: DrawnContact, drawn: Map, scale: Any) -> None:
    """Cells in contact in their colours, the ellipse around them."""
    from matplotlib.patches import Ellipse

    across, along = 1e3 * contact.places
    values = np.ma.masked_where(~contact.touching, drawn.values(contact))
    axes.pcolormesh(across, along, values, shading="nearest", cmap=scale.cmap, norm=scale.norm)
    sides = [2e3 * semi_axis for semi_axis in contact.semi_axes]
    axes.add_patch(Ellipse((0, 0), *sides, fill=False, edgecolor="0.3", linewidth=0.7))
    if drawn.arrows:
        _draw_arrows(axes, contact)
    if not drawn.colours:
        share = contact.stick[contact.touching].mean()
        axes.text(
            0.995,
            0.97,
            f"{100 * share:.2g} % sticks",
            fontsize=7,
            ha="right",
            va="top",
            transform=axes.transAxes,
        )


def _draw_arrows(axes: Axes, contact: DrawnContact) -> None:
    """Directions of the shear stress, so far apart that every arrow is seen."""
    size = np.hypot(*contact.shear)
    kept = np.zeros(size.shape, bool)
    inches = PANEL / np.ptp(axes.get_xlim())
    kept[np.ix_(*map(list, _apart(contact, inches)))] = True
    kept &= contact.touching & (size > 0)
    across, along = 1e3 * contact.places
    axes.quiver(
        across[kept],
        along[kept],
        *(contact.shear[:, kept] / size[kept]),
        color="0.1",
        pivot="mid",
        units="inches",
        scale_units="inches",
        scale=1 / ARROW,
        width=0.011,
        headwidth=4.5,
        headlength=4.5,
        headaxislength=4,
        clip_on=False,
    )


def _apart(contact: DrawnContact, inches: float) -> Iterator[np.ndarray]:
    """Numbers of cells across and along that are as far apart as arrows need, for inches per mm."""
    lengths = (1e3 * np.ptp(place) * inches for place in contact.places)
    for cells, length, distance in zip(contact.pressure.shape, lengths, (ACROSS, ALONG), strict=True):
        step = max(1, round(cells * distance / max(length, distance)))
        last = (cells // step - 1) * step
        yield (cells - 1 - last) // 2 + np.arange(0, last + 1, step)


def _draw_scales(page: _Page, top: float, drawn: list[tuple[Map, Any]]) -> None:
    """Scales of colours side by side, and the legend of stick and slip."""
    from matplotlib.patches import Patch

    share = (page.width - LEFT - RIGHT) / len(drawn)
    for number, (each, scale) in enumerate(drawn):
        left = LEFT + number * share
        if each.colours:
            axes = page.axes(left, top, share - 2 * GAP, BAR)
            bar = page.figure.colorbar(scale, cax=axes, orientation="horizontal", format=NUMBERS)
            bar.set_label(each.label, fontsize=8, labelpad=2)
            bar.ax.tick_params(labelsize=7, length=2.5, pad=2)
        else:
            patches = [Patch(color=STICK, label="stick"), Patch(color=SLIP, label="slip")]
            anchor = (left / page.width, (top + BAR) / page.height)
            close = {"frameon": False, "ncols": 2, "borderpad": 0, "borderaxespad": 0}
            page.figure.legend(handles=patches, loc="upper left", bbox_to_anchor=anchor, fontsize=8, **close)
