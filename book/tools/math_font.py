"""Makes the book's math font from TeX Gyre Pagella Math 1.632.

    apt-get install fonts-texgyre-math && pip install fonttools brotli
    python3 math_font.py texgyrepagella-math.otf ../theme/fonts/RayByRayMath.woff2

Four things are changed, and the font renamed, as its licence asks:

1. Characters that formulas do not use are left out.
2. Primes have their script form from the start: Chromium ignores the OpenType feature `ssty`,
   which should choose it, and would draw x′ with a prime too small to see.
3. On a line of its own the integral sign is taken two sizes larger.
4. The hints for coarse screens are left out.
"""

import sys

from fontTools import subset
from fontTools.ttLib import TTFont

NAME = "Ray by Ray Math"
PRIMES = (0x2032, 0x2033, 0x2034, 0x2057, 0x2035)
RANGES = (
    (0x0020, 0x024F),  # Latin
    (0x0300, 0x036F),  # accents
    (0x0370, 0x03FF),  # Greek
    (0x2000, 0x2BFF),  # punctuation, letterlike, arrows, operators, brackets, shapes
    (0x1D400, 0x1D7FF),  # mathematical letters
)


def script_forms(font):
    """The glyph that the feature `ssty` puts in place of another, for each that it knows."""
    table = font["GSUB"].table
    records = [r for r in table.FeatureList.FeatureRecord if r.FeatureTag == "ssty"]
    lookups = {i for record in records for i in record.Feature.LookupListIndex}
    forms = {}
    for index in sorted(lookups):
        for part in table.LookupList.Lookup[index].SubTable:
            part = getattr(part, "ExtSubTable", part)
            for glyph, others in getattr(part, "alternates", {}).items():
                forms.setdefault(glyph, others[0])
            for glyph, other in getattr(part, "mapping", {}).items():
                forms.setdefault(glyph, other)
    return forms


def main(source, target):
    font = TTFont(source)
    forms = script_forms(font)
    for table in font["cmap"].tables:
        for prime in PRIMES:
            if table.isUnicode() and prime in table.cmap:
                glyph = table.cmap[prime]
                # Tables may share one mapping, which then is changed already.
                table.cmap[prime] = forms.get(glyph, glyph)

    options = subset.Options()
    options.layout_features = ["*"]
    options.name_IDs = ["*"]
    options.notdef_outline = True
    options.hinting = False
    options.drop_tables += ["FFTM"]
    subsetter = subset.Subsetter(options)
    wanted = [c for first, last in RANGES for c in range(first, last + 1)]
    subsetter.populate(unicodes=[c for c in font.getBestCmap() if c in set(wanted)])
    subsetter.subset(font)

    font["MATH"].table.MathConstants.DisplayOperatorMinHeight = 2000
    new_names = {1: NAME, 4: NAME, 6: NAME.replace(" ", ""), 16: NAME}
    for record in font["name"].names:
        record.string = new_names.get(record.nameID, record.toUnicode())
    origin = "Changed from TeX Gyre Pagella Math 1.632: a selection, other primes, larger integrals."
    font["name"].setName(origin, 10, 3, 1, 0x409)
    font["head"].modified = font["head"].created  # the same bytes whenever it is made
    font.recalcTimestamp = False
    font.flavor = "woff2"
    font.save(target)


if __name__ == "__main__":
    main(*sys.argv[1:])
