using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Fonts.Finding;
using Engraver.TestKit;
using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.Tests.Lettering;

/// <summary>A TEXT written by a test, laid out with a font of the test: a stroke font with arcs, an outline font with quadratics, or squares.</summary>
internal static class LetteredLine
{
    /// <summary>Of 400 units on the baseline at x = 100 for H and A; advance 600, capital letters 400, descent 200.</summary>
    public const string Squares = "squares.ttf";

    /// <summary>The outline font of the samples.</summary>
    public const string Outlines = "plate-letters.ttf";

    /// <summary>Two squares of 400 units that overlap in a square of 200, for the letters of a ring and a stroke.</summary>
    public const string Crossing = "crossing.ttf";

    public const double MaxError = 0.002;

    private static readonly Lazy<FontLibrary> s_library = new(() =>
    {
        var folder = Directory.CreateTempSubdirectory("engraver-letters-").FullName;
        File.WriteAllBytes(Path.Combine(folder, Squares), FontBuilder.TrueType("Squares", 4, 'A', 'H').Build());
        File.WriteAllBytes(Path.Combine(folder, Crossing), FontBuilder.TrueType("Crossing", 4, 'H', 0xC5, 0xD8).With("glyf", TwoSquares()).With("loca", [0, 0, 0, 0, .. FontBuilder.U16(TwoSquares().Length / 2)]).Build());
        File.Copy(Path.Combine(RepositoryFolder.Samples, Outlines), Path.Combine(folder, Outlines));
        return new FontLibrary([folder], FontSubstitutes.Standard);
    });

    public static LetterFonts Fonts(string font, double fixedHeight = 0.0) => new([new TextStyle("S") { FontFile = font, FixedHeight = fixedHeight }], s_library.Value, []);

    public static PlacedText Text(WrittenText written, Placement? inserts = null) => new()
    {
        Type = "TEXT",
        Content = written.Raw,
        Position = written.Insertion,
        Height = written.Height,
        Rotation = written.Rotation,
        Style = "s",
        Font = "",
        Written = written,
        Inserts = inserts ?? Placement.Identity,
        Layer = 0,
    };

    /// <summary>The curves of a text of squares.</summary>
    public static LetterCurves CurvesOf(WrittenText written, Placement? inserts = null, string font = Squares) => LetterCurves.Of(LineLayout.Of(Text(written, inserts), Fonts(font))!, MaxError);

    /// <summary>The box of a text of squares, rounded to a millionth.</summary>
    public static (double MinX, double MinY, double MaxX, double MaxY) BoxOf(WrittenText written, Placement? inserts = null)
    {
        var curves = CurvesOf(written, inserts);
        var box = curves.Parts.Aggregate(Bounds2D.Empty, (all, part) => all.Union(part.IsFreeCurve ? curves.Curves[part.CurveIndex].Bounds : part.InPlan().Bounds));
        return (Round(box.MinX), Round(box.MinY), Round(box.MaxX), Round(box.MaxY));
    }

    /// <summary>Squares at 100,0 and 300,200; eight points, all on the outline, coordinates as differences.</summary>
    private static byte[] TwoSquares()
    {
        int[] x = [100, 400, 0, -400, 200, 400, 0, -400], y = [0, 0, 400, 0, -200, 0, 400, 0];
        return [.. Words(2, 100, 0, 700, 600, 3, 7, 0), .. Enumerable.Repeat((byte)1, 8), .. Words(x), .. Words(y)];

        static IEnumerable<byte> Words(params int[] values) => values.SelectMany(FontBuilder.U16);
    }

    private static double Round(double value) => Math.Round(value, 6) + 0.0;
}
