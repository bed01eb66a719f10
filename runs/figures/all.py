"""The paper's figures and claims, computed; see runs/figures/run."""

import argparse
import pathlib

import claims
import dilation
import force_displacement
import interpolation
import pages
import sandstone
import solves
import steel
import surfaces

PARTS = {
    "figure_2": sandstone.figure_2,
    "figure_3": sandstone.figure_3,
    "figure_4": surfaces.figure_4,
    "figure_5": sandstone.figure_5,
    "figure_6": steel.figure_6,
    "figures_7_10": interpolation.figures_7_10,
    "figures_11_12": force_displacement.figures_11_12,
    "section_3_4": claims.section_3_4,
    "dilation": dilation.dilation,
}


def main():
    parser = argparse.ArgumentParser(prog="runs/figures/run", description=__doc__)
    parser.add_argument("--only", choices=PARTS, action="append", help="one part, may be repeated")
    parser.add_argument("--output", type=pathlib.Path, default=solves.PROGRAM.parent / "figures",
                        help="folder for pictures, tables and finished solves [build/figures]")
    arguments = parser.parse_args()
    book = pages.Pages(arguments.output)
    computed = solves.Solves(arguments.output / "solves")
    for name, part in PARTS.items():
        if name in (arguments.only or PARTS):
            solves.say(name.replace("_", " "))
            part(book, computed)
    book.finish()
    solves.say(f"done, {computed.computed} solves computed, see {arguments.output}/summary.csv")


if __name__ == "__main__":
    main()
