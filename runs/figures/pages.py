"""Pictures, CSV files and the summary."""

import csv

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# Distinct in colour and in grey, and to the colour-blind (Okabe & Ito).
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
SUMMARY = ["figure", "quantity", "ours", "theirs", "difference", "why"]

plt.rcParams.update({
    "figure.dpi": 150, "savefig.bbox": "tight", "font.size": 10, "axes.grid": True,
    "grid.alpha": 0.3, "axes.prop_cycle": plt.cycler(color=COLOURS), "legend.framealpha": 0.9,
    "axes.spines.top": False, "axes.spines.right": False, "lines.linewidth": 1.6,
})


class Pages:
    def __init__(self, directory):
        self.directory = directory
        self.rows = []
        directory.mkdir(parents=True, exist_ok=True)

    def figure(self, name, width=6.0, height=4.2, columns=1):
        """(figure, axes); save() gives it its name."""
        return plt.subplots(1, columns, figsize=(width, height))

    def space_and_lines(self, count):
        """(figure, axes in space, axes of lines beside them ...)"""
        figure = plt.figure(figsize=(6.2 + 2.9 * count, 4.2))
        # The second column is room for the labels of the third axis.
        grid = list(figure.add_gridspec(1, 2 + count, width_ratios=[2.1, .05] + [1] * count, wspace=.28))
        return figure, figure.add_subplot(grid[0], projection="3d"), *map(figure.add_subplot, grid[2:])

    def colours(self, values):
        """From values to colours, for faces and their bar."""
        return plt.cm.ScalarMappable(plt.Normalize(values.min(), values.max()), "viridis")

    def save(self, figure, name):
        figure.savefig(self.directory / f"{name}.png")
        plt.close(figure)

    def csv(self, name, columns, comments=()):
        """A file of columns {heading with unit: values}, of unequal length where need be."""
        with open(self.directory / f"{name}.csv", "w", newline="", encoding="utf-8") as file:
            for comment in comments:
                file.write(f"# {comment}\n")
            writer = csv.writer(file)
            writer.writerow(columns)
            length = max(len(values) for values in columns.values())
            for i in range(length):
                writer.writerow([text(values[i]) if i < len(values) else "" for values in columns.values()])

    def summarise(self, figure, quantity, ours, theirs="", difference="", why=""):
        """One line of summary.csv. Where ours and theirs are numbers the difference is made here."""
        if difference == "" and isinstance(ours, (int, float)) and isinstance(theirs, (int, float)):
            difference = f"{100 * (ours / theirs - 1):+.3g} %"
        self.rows.append([figure, quantity, text(ours), text(theirs), text(difference), why])

    def finish(self):
        """Writes the summary; rows of figures that were not made this time stay."""
        made = {row[0] for row in self.rows}
        if (self.directory / "summary.csv").is_file():
            with open(self.directory / "summary.csv", newline="", encoding="utf-8") as file:
                self.rows += [row for row in list(csv.reader(file))[1:] if row[0] not in made]
        with open(self.directory / "summary.csv", "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(SUMMARY)
            writer.writerows(self.rows)


def text(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)
