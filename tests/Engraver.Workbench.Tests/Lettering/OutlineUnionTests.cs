using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Fonts;
using Engraver.Fonts.Finding;
using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.Tests.Lettering;

/// <summary>Outlines that overlap are united; what does not overlap stays exact.</summary>
public class OutlineUnionTests
{
    private const double MaxError = 0.0005;

    [Fact]
    public void Contours_of_a_glyph_that_cross_become_one_outline()
    {
        var curves = CurvesOf(new GlyphCurves(30.0, [Square(0.0, 0.0, 20.0), Square(10.0, 10.0, 20.0)]));

        Assert.Equal(8, curves.Parts.Count);
        Assert.Equal(120.0, LengthOf(curves), 9); // the outline of two squares of 20 that share one of 10: 160 less twice 20
        Assert.True(curves.IsUnited);
    }

    [Fact]
    public void A_hole_stays_and_is_exact()
    {
        var curves = CurvesOf(new GlyphCurves(30.0, [Square(0.0, 0.0, 20.0), Hole(5.0, 5.0, 10.0)]));

        Assert.Equal(8, curves.Parts.Count);
        Assert.Equal(120.0, LengthOf(curves), 9);
    }

    [Fact]
    public void Neighbours_that_overlap_are_united()
    {
        var curves = CurvesOf(new GlyphCurves(15.0, [Square(0.0, 0.0, 20.0)]), repeats: 3);

        Assert.Equal(2.0 * (50.0 + 20.0), LengthOf(curves), 9);
    }

    [Fact]
    public void A_curve_that_nothing_crosses_remains_the_curve_of_the_font()
    {
        var drop = new GlyphContour(new FontPoint(0.0, 0.0), [GlyphPiece.Cubic(new FontPoint(20.0, 0.0), new FontPoint(20.0, 20.0), new FontPoint(0.0, 20.0)), GlyphPiece.Line(new FontPoint(0.0, 0.0))], IsClosed: true);

        var curves = CurvesOf(new GlyphCurves(18.0, [drop]), repeats: 2); // the boxes do not meet: the curve reaches 15

        Assert.Equal(2, curves.Curves.Count);
        Assert.Equal(4, curves.Parts.Count);
    }

    [Fact]
    public void United_curves_keep_the_error()
    {
        var drop = new GlyphContour(new FontPoint(0.0, 0.0), [GlyphPiece.Cubic(new FontPoint(20.0, 0.0), new FontPoint(20.0, 20.0), new FontPoint(0.0, 20.0)), GlyphPiece.Line(new FontPoint(0.0, 0.0))], IsClosed: true);
        var exact = LetterContour.Of(drop, Placement.Identity).Curves[0];

        var curves = CurvesOf(new GlyphCurves(40.0, [drop, Square(10.0, 5.0, 10.0)]));

        Assert.Empty(curves.Curves);
        var beside = curves.Parts.Where(part => part.Kind == SegmentKind.Arc).Select(part => part.InPlan()).SelectMany(arc => Enumerable.Range(0, 21).Select(i => exact.DistanceTo(arc.PointAt(i / 20.0)))).ToList();
        Assert.True(beside.Count > 100);
        Assert.InRange(beside.Max(), 0.0, MaxError);
    }

    private static LetterCurves CurvesOf(GlyphCurves glyph, int repeats = 1)
    {
        var font = new FoundFont(new OneGlyphFont(glyph), new FontRequest("", "", IsBold: false, IsItalic: false), FontMatch.Exact, FontTrouble.None, null, "");
        var run = LetterRun.Set(new string('x', repeats), font, LetterFormat.Upright(10.0), Point2D.Origin, new LayoutNotes());
        return LetterCurves.Of(new TextLayout(Placement.Identity, run.Glyphs, [], []), MaxError);
    }

    private static double LengthOf(LetterCurves curves) => curves.Parts.Sum(part => part.IsFreeCurve ? curves.Curves[part.CurveIndex].PlanLength : part.SpaceLength);

    private static GlyphContour Square(double x, double y, double side) => Contour(new FontPoint(x, y), new FontPoint(x + side, y), new FontPoint(x + side, y + side), new FontPoint(x, y + side));

    private static GlyphContour Hole(double x, double y, double side) => Contour(new FontPoint(x, y), new FontPoint(x, y + side), new FontPoint(x + side, y + side), new FontPoint(x + side, y));

    private static GlyphContour Contour(params FontPoint[] corners) => new(corners[0], [.. corners.Skip(1).Append(corners[0]).Select(GlyphPiece.Line)], IsClosed: true);

    /// <summary>A font with one shape, whose units are drawing units at a height of 10.</summary>
    private sealed class OneGlyphFont(GlyphCurves glyph) : ITextFont
    {
        public string Name => "one glyph";

        public bool IsOutline => true;

        public FontMetrics Metrics => new(10.0, 10.0, 10.0, 2.0, 15.0);

        public bool Contains(int codePoint) => true;

        public GlyphCurves? GlyphOf(int codePoint) => glyph;

        public double KerningOf(int left, int right) => 0.0;
    }
}
