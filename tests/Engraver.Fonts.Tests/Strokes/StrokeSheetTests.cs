using System.Globalization;
using System.Text;
using Engraver.Fonts.Strokes;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.Strokes;

/// <summary>Sheets of all characters, to be looked at: artifacts/pictures/stroke-font.svg and double-stroke-font.svg.</summary>
public class StrokeSheetTests
{
    private const int Columns = 20, CellWidth = 90, CellHeight = 130;
    private const double Scale = 0.08;

    [Theory]
    [InlineData("stroke-font.svg", false)]
    [InlineData("double-stroke-font.svg", true)]
    public void A_sheet_shows_every_character(string name, bool isDouble)
    {
        ITextFont font = isDouble ? DoubleStrokeFont.Engraver : StrokeFont.Engraver;
        var codes = StrokeFont.Engraver.CodePoints.ToList();
        var sheet = Sheet(font, codes, isDouble ? 8 : 55);
        var folder = Path.Combine(RepositoryFolder.Root, "artifacts/pictures");
        Directory.CreateDirectory(folder);
        File.WriteAllText(Path.Combine(folder, name), sheet);

        Assert.Equal(codes.Count(code => font.GlyphOf(code)!.Contours.Count > 0), sheet.Split("<path").Length - 1);
        Assert.DoesNotContain("NaN", sheet, StringComparison.Ordinal);
    }

    private static string Sheet(ITextFont font, List<int> codes, double pen)
    {
        var text = new StringBuilder();
        var (width, height) = (Columns * CellWidth, ((codes.Count + Columns - 1) / Columns * CellHeight) + 40);
        text.Append(CultureInfo.InvariantCulture, $"""<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}"><rect width="{width}" height="{height}" fill="#fff"/>""");
        for (var i = 0; i < codes.Count; i++)
        {
            var glyph = font.GlyphOf(codes[i])!;
            var (x, y) = ((i % Columns * CellWidth) + (CellWidth / 2.0), (i / Columns * CellHeight) + 95.0);
            if (glyph.Contours.Count > 0) text.Append(CultureInfo.InvariantCulture, $"""<path d="{PathOf(glyph, x - (glyph.Advance * Scale / 2), y)}" stroke="#000" stroke-width="{pen * Scale}" fill="none" stroke-linecap="round" stroke-linejoin="round"/>""");
            text.Append(CultureInfo.InvariantCulture, $"""<text x="{x}" y="{y + 30}" font-size="8" text-anchor="middle" fill="#777">{codes[i]:X4}</text>""");
        }

        return text.Append("</svg>\n").ToString();
    }

    private static string PathOf(GlyphCurves glyph, double x, double y)
    {
        var text = new StringBuilder();
        foreach (var contour in glyph.Contours)
        {
            text.Append(CultureInfo.InvariantCulture, $"M{x + (contour.Start.X * Scale):0.###} {y - (contour.Start.Y * Scale):0.###}");
            foreach (var piece in StrokeGlyphs.Pieces(contour))
            {
                text.Append(piece.IsLine ? "L" : string.Create(CultureInfo.InvariantCulture, $"A{piece.Radius * Scale:0.####} {piece.Radius * Scale:0.####} 0 {(Math.Abs(piece.Sweep) > Math.PI ? 1 : 0)} {(piece.Bulge < 0 ? 1 : 0)} "));
                text.Append(CultureInfo.InvariantCulture, $"{x + (piece.End.X * Scale):0.###} {y - (piece.End.Y * Scale):0.###}");
            }

            if (contour.IsClosed) text.Append('Z');
        }

        return text.ToString();
    }
}
