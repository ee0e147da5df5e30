using System.Diagnostics;
using System.Text.Json;
using Engraver.Fonts.OpenType;

namespace Engraver.Fonts.Tests.OpenType;

/// <summary>Widths, curves, kerning and heights of installed fonts as fontTools reads them.</summary>
public class FontToolsTests
{
    private const string DejaVu = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    private const string Garuda = "/usr/share/fonts/truetype/tlwg/Garuda.ttf";
    private const string Nimbus = "/usr/share/fonts/opentype/urw-base35/NimbusSans-Regular.otf";

    /// <summary>Prints a font: some of its characters with their width and curves, and the distances of pairs of letters.</summary>
    private const string Print = """
        import sys, json
        from fontTools.ttLib import TTFont
        from fontTools.pens.basePen import BasePen
        class Pen(BasePen):
            def __init__(self, glyphs):
                super().__init__(glyphs)
                self.out = []
            def _moveTo(self, p): self.out.append(["M", *p])
            def _lineTo(self, p): self.out.append(["Line", *p])
            def _qCurveToOne(self, a, b): self.out.append(["Quadratic", *a, *b])
            def _curveToOne(self, a, b, c): self.out.append(["Cubic", *a, *b, *c])
            def _closePath(self): self.out.append(["Z"])
        font = TTFont(sys.argv[1])
        glyphs, cmap = font.getGlyphSet(), font.getBestCmap()
        class Parts:
            def __getitem__(self, name): return Part(name)
        class Part:
            def __init__(self, name): self.name = name
            def draw(self, pen): font["glyf"][self.name].draw(pen, font["glyf"])
        def curves(name):
            if "glyf" not in font:
                pen = Pen(glyphs)
                glyphs[name].draw(pen)
                return pen.out
            # Only the glyph itself is moved to its left edge, not the parts that it is made of.
            glyph, pen = font["glyf"][name], Pen(Parts())
            glyph.draw(pen, font["glyf"])
            aside = font["hmtx"][name][1] - glyph.xMin if glyph.numberOfContours else 0
            return [[command[0]] + [value + (0 if i % 2 else aside) for i, value in enumerate(command[1:])] for command in pen.out]
        def newer(left, right):
            table, total = font["GPOS"].table, 0
            for index in sorted({i for f in table.FeatureList.FeatureRecord if f.FeatureTag == "kern" for i in f.Feature.LookupListIndex}):
                for sub in table.LookupList.Lookup[index].SubTable:
                    value = pair(getattr(sub, "ExtSubTable", sub), left, right)
                    if value is not None:
                        total += value
                        break
            return total
        def pair(sub, left, right):
            if left not in sub.Coverage.glyphs: return None
            if sub.Format == 1:
                for record in sub.PairSet[sub.Coverage.glyphs.index(left)].PairValueRecord:
                    if record.SecondGlyph == right: return record.Value1.XAdvance if record.Value1 else 0
                return None
            value = sub.Class1Record[sub.ClassDef1.classDefs.get(left, 0)].Class2Record[sub.ClassDef2.classDefs.get(right, 0)].Value1
            return getattr(value, "XAdvance", 0) if value else 0
        def older(left, right): return sum(t.kernTable.get((left, right), 0) for t in font["kern"].kernTables)
        has_newer = "GPOS" in font and any(f.FeatureTag == "kern" for f in font["GPOS"].table.FeatureList.FeatureRecord)
        kern = newer if has_newer else older if "kern" in font else lambda left, right: 0
        codes = [c for i, c in enumerate(sorted(cmap)) if c < 0x180 or i % 7 == 0]
        letters = [c for c in map(ord, "AFLPTVWYacefgorvwy.,-'") if c in cmap]
        os2, hhea = font["OS/2"], font["hhea"]
        typographic = os2.fsSelection & 128
        print(json.dumps({
            "count": len(cmap), "kern": [[a, b, kern(cmap[a], cmap[b])] for a in letters for b in letters],
            "heights": [font["head"].unitsPerEm, getattr(os2, "sCapHeight", 0)] + ([os2.sTypoAscender, -os2.sTypoDescender, os2.sTypoLineGap] if typographic else [hhea.ascent, -hhea.descent, hhea.lineGap]),
            "glyphs": [[c, font["hmtx"][cmap[c]][0], curves(cmap[c])] for c in codes], "name": str(font["name"].getName(4, 3, 1, 0x409)), "weight": os2.usWeightClass}))
        """;

    [FontToolsFact(DejaVu)]
    public void A_TrueType_font_is_the_same() => Compare(DejaVu, GlyphPieceKind.Quadratic, hasKerning: true);

    [FontToolsFact(Garuda)]
    public void Another_TrueType_font_is_the_same() => Compare(Garuda, GlyphPieceKind.Quadratic, hasKerning: false);

    [FontToolsFact(Nimbus)]
    public void A_font_of_cubic_curves_is_the_same() => Compare(Nimbus, GlyphPieceKind.Cubic, hasKerning: true);

    private static void Compare(string path, GlyphPieceKind kind, bool hasKerning)
    {
        using var printed = Printed(path);
        var root = printed.RootElement;
        var font = new OutlineFont(new DiskFontSource(path));
        double[] heights = [.. root.GetProperty("heights").EnumerateArray().Select(height => height.GetDouble())];

        Assert.Equal((root.GetProperty("name").GetString(), root.GetProperty("weight").GetInt32()), (font.Name, font.Weight));
        Assert.Equal((heights[0], heights[2], heights[3], heights[2] + heights[3] + heights[4]), (font.Metrics.UnitsPerEm, font.Metrics.Ascent, font.Metrics.Descent, font.Metrics.LineSpacing));
        if (heights[1] > 0) Assert.Equal(heights[1], font.Metrics.CapHeight);
        Assert.Equal(root.GetProperty("count").GetInt32(), Enumerable.Range(0, 0x110000).Count(font.Contains));
        foreach (var glyph in root.GetProperty("glyphs").EnumerateArray())
        {
            var read = font.GlyphOf(glyph[0].GetInt32())!;
            Assert.Equal(glyph[1].GetDouble(), read.Advance);
            Assert.Equal(Normalized(glyph[2]), Written(read), StringComparer.Ordinal);
        }
        Assert.Contains(kind, font.GlyphOf('O')!.Contours.SelectMany(contour => contour.Pieces).Select(piece => piece.Kind));
        var pairs = root.GetProperty("kern").EnumerateArray().Select(pair => (Left: pair[0].GetInt32(), Right: pair[1].GetInt32(), Value: pair[2].GetDouble())).ToList();
        Assert.Equal(pairs, pairs.Select(pair => (pair.Left, pair.Right, font.KerningOf(pair.Left, pair.Right))));
        Assert.Equal(hasKerning, pairs.Any(pair => pair.Value < 0));
    }

    /// <summary>One line for each contour, with the line that closes it, and without pieces of no length and contours of one or two points.</summary>
    private static List<string> Normalized(JsonElement commands)
    {
        var contours = new List<string>();
        var contour = new List<string>();
        (double X, double Y) start = default, at = default;
        foreach (var command in commands.EnumerateArray())
        {
            double[] values = [.. command.EnumerateArray().Skip(1).Select(value => value.GetDouble())];
            switch (command[0].GetString())
            {
                case "M":
                    contour = [Text("M", values)];
                    start = at = (values[0], values[1]);
                    break;
                case "Z":
                    if (at != start) contour.Add(Text("Line", [start.X, start.Y]));
                    if (contour.Count > 3 || contour.Any(piece => piece[0] is 'Q' or 'C')) contours.Add(string.Join(' ', contour));
                    break;
                default:
                    if (values is not [var x, var y] || (x, y) != at) contour.Add(Text(command[0].GetString()!, values));
                    at = (values[^2], values[^1]);
                    break;
            }
        }
        return contours;
    }

    private static List<string> Written(GlyphCurves glyph) =>
        [.. glyph.Contours.Select(contour => string.Join(' ', contour.Pieces.Select(Text).Prepend(Text("M", [contour.Start.X, contour.Start.Y]))))];

    private static string Text(GlyphPiece piece) => Text(piece.Kind.ToString(), piece.Kind switch
    {
        GlyphPieceKind.Line => [piece.End.X, piece.End.Y],
        GlyphPieceKind.Quadratic => [piece.Control1.X, piece.Control1.Y, piece.End.X, piece.End.Y],
        _ => [piece.Control1.X, piece.Control1.Y, piece.Control2.X, piece.Control2.Y, piece.End.X, piece.End.Y],
    });

    private static string Text(string kind, double[] values) => FormattableString.Invariant($"{kind} {string.Join(' ', values.Select(value => FormattableString.Invariant($"{value:0.###}")))}");

    private static JsonDocument Printed(string path)
    {
        using var process = Process.Start(new ProcessStartInfo(FontToolsFactAttribute.Python, ["-I", "-c", Print, path]) { RedirectStandardOutput = true })!;
        var text = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.Equal(0, process.ExitCode);
        return JsonDocument.Parse(text);
    }
}
