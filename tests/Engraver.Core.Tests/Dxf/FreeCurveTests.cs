using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Tools.CrossChecks;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Ellipses, splines, and circles that become ellipses by a tilt or an unequal scale.</summary>
public class FreeCurveTests
{
    private const double QuarterOfTwoToOne = 12.110560275684595; // half-diameters 10 and 5

    private static readonly (int, object)[] Ellipse = [(0, "ELLIPSE"), (10, 0), (20, 0), (11, 10), (21, 0), (40, 0.5)];

    private static readonly (int, object)[] Spline =
        [(0, "SPLINE"), (71, 3), (40, 0), (40, 0), (40, 0), (40, 0), (40, 1), (40, 1), (40, 1), (40, 1), (10, 0), (20, 0), (10, 1), (20, 2), (10, 3), (20, 2), (10, 4), (20, 0)];

    [Fact]
    public void A_quarter_of_an_ellipse_has_its_length_and_ends()
    {
        var drawing = DxfReading.Entities([.. Ellipse, (41, 0), (42, Math.PI / 2.0)]);
        var summary = DrawingSummary.From(drawing);

        Assert.Equal(QuarterOfTwoToOne, summary.Length.Ellipse, 1e-9);
        Assert.Equal((1, 1), (summary.Leaf[CurveType.Ellipse], summary.Primitives.Ellipse));
        Assert.Equal((10.0, 0.0, 0.0, 5.0), (drawing.Curves[0].Start.X, drawing.Curves[0].Start.Y, drawing.Curves[0].End.X, drawing.Curves[0].End.Y));
        Assert.False(drawing.Entities[0].Closed);
    }

    [Fact]
    public void An_extrusion_downwards_turns_the_sense_round()
    {
        var drawing = DxfReading.Entities([.. Ellipse, (41, 0), (42, Math.PI / 2.0), (230, -1)]);

        Assert.Equal((0.0, -5.0), (drawing.Curves[0].End.X, drawing.Curves[0].End.Y));
        Assert.Empty(drawing.Diagnostics);
    }

    [Fact]
    public void An_ellipse_of_ratio_1_is_a_circle_to_the_machine_and_an_ellipse_to_the_books()
    {
        var drawing = DxfReading.Entities((0, "ELLIPSE"), (10, 1), (20, 2), (11, 0), (21, 3), (40, 1));
        var summary = DrawingSummary.From(drawing);

        Assert.Equal(SegmentKind.Circle, drawing.Parts[0].Kind);
        Assert.Equal((1, 6.0 * Math.PI), (summary.Leaf[CurveType.Ellipse], summary.Length.Ellipse));
    }

    [Fact]
    public void An_arc_in_an_unequally_scaled_block_is_elliptical_and_still_counts_as_arc()
    {
        var drawing = Inserting([(0, "ARC"), (10, 0), (20, 0), (40, 5), (50, 0), (51, 90)], (0, "INSERT"), (2, "B"), (10, 0), (20, 0), (41, 2));
        var summary = DrawingSummary.From(drawing);

        Assert.Equal(SegmentKind.Ellipse, drawing.Parts[0].Kind);
        Assert.Equal(1, summary.Leaf[CurveType.Arc]);
        Assert.Equal(QuarterOfTwoToOne, summary.Length.Arc, 1e-9);
        Assert.Equal((10.0, 0.0, 0.0, 5.0), (drawing.Curves[0].Start.X, drawing.Curves[0].Start.Y, drawing.Curves[0].End.X, drawing.Curves[0].End.Y));
        Assert.Empty(drawing.Diagnostics);
    }

    [Fact]
    public void A_tilted_circle_keeps_its_length_in_space_and_shows_an_ellipse_in_plan()
    {
        var drawing = DxfReading.Entities((0, "CIRCLE"), (10, 0), (20, 0), (40, 10), (220, 1), (230, 1));
        var summary = DrawingSummary.From(drawing);
        var plan = FreeCurves.Ellipse(0, 0, 10.0, Math.Sqrt(0.5), 0.0, 0.0, 360.0).ToCurve().PlanLength;

        Assert.Equal(20.0 * Math.PI, summary.Length.Circle, 1e-9);
        Assert.Equal(plan, summary.Length.PlanTotal, 1e-9);
        Assert.Equal(["DXF0014"], DxfReading.Ids(drawing));
    }

    [Property]
    public Property Exploding_equals_transforming() => Prop.ForAll(Gen.Choose(-30, 30).Three().ToArbitrary(), numbers =>
    {
        var (x, y, turn) = (numbers.Item1 == 0 ? 1.0 : numbers.Item1 / 10.0, numbers.Item2 == 0 ? 1.0 : numbers.Item2 / 10.0, 6.0 * numbers.Item3);
        var (cos, sin) = (Angle.FromDegrees(turn).Cos(), Angle.FromDegrees(turn).Sin());
        Point2D Moved(Point2D p) => new((x * p.X * cos) - (y * p.Y * sin) + 7.0, (x * p.X * sin) + (y * p.Y * cos) - 3.0);
        foreach (var content in new[] { Spline, [.. Ellipse, (41, 0.3), (42, 5.0)] })
        {
            var (plain, placed) = (DxfReading.Entities(content).Curves[0], Inserting(content, (0, "INSERT"), (2, "B"), (10, 7), (20, -3), (41, x), (42, y), (50, turn)).Curves[0]);
            for (var i = 0; i <= 20; i++)
            {
                if (!placed.PointAt(i / 20.0).IsNear(Moved(plain.PointAt(i / 20.0)), 1e-11)) return false;
            }
        }

        return true;
    });

    [Theory]
    [InlineData("40 0 1 2")]
    [InlineData("40 0 0 0 0 0 0 0 0")]
    [InlineData("40 0 0 0 0 1 1 1 0")]
    [InlineData("")]
    public void Unusable_knots_are_replaced_and_said_so(string knots)
    {
        (int, object)[] written = [.. knots.Split(' ', StringSplitOptions.RemoveEmptyEntries).Skip(1).Select(knot => (40, (object)knot))];
        var drawing = DxfReading.Entities([(0, "SPLINE"), (71, 3), .. written, .. Spline.Where(pair => pair.Item1 is 10 or 20)]);

        Assert.Equal(["DXF0021"], DxfReading.Ids(drawing));
        Assert.Equal(DxfReading.Entities(Spline).Curves[0].PlanLength, drawing.Curves[0].PlanLength, 1e-12);
    }

    [Fact]
    public void Too_few_knots_that_are_not_clamped_are_not_completed()
    {
        (int, object)[] points = [(10, 0), (20, 0), (10, 0), (20, 9), (10, 3), (20, 3), (10, 3), (20, 0), (10, 4), (20, 0)];
        Drawing With(params double[] written) => DxfReading.Entities([(0, "SPLINE"), (71, 3), .. written.Select(knot => (40, (object)knot)), .. points]);
        var drawing = With(0, 1, 2, 3, 4, 5, 6);

        Assert.Equal(With(0, 0, 0, 0, 1, 2, 2, 2, 2).Curves[0].PlanLength, drawing.Curves[0].PlanLength);
        Assert.Contains("uniform knots", Assert.Single(drawing.Diagnostics).Message, StringComparison.Ordinal);
    }

    /// <summary>OpenNURBS writes neither the first nor the last knot; no point of the curve depends on them.</summary>
    [Theory]
    [InlineData("0 0 0 2 5 5 5")]
    [InlineData("-2 -2 -2 2 5 5 5")]
    public void Two_missing_knots_are_the_first_and_the_last(string numbers)
    {
        double[] knots = [.. numbers.Split(' ').Select(number => double.Parse(number, System.Globalization.CultureInfo.InvariantCulture))];
        (int, object)[] points = [(10, 0), (20, 0), (10, 0), (20, 9), (10, 3), (20, 3), (10, 3), (20, 0), (10, 4), (20, 0)];
        Drawing With(params double[] written) => DxfReading.Entities([(0, "SPLINE"), (71, 3), .. written.Select(knot => (40, (object)knot)), .. points]);
        var (whole, two) = (With([knots[0], .. knots, knots[^1]]), With(knots));

        Assert.Equal(whole.Curves[0].PlanLength, two.Curves[0].PlanLength);
        Assert.Contains("two knots are missing", Assert.Single(two.Diagnostics).Message, StringComparison.Ordinal);
        Assert.Equal("DXF0021", two.Diagnostics[0].Id);
        Assert.Empty(whole.Diagnostics);
    }

    /// <summary>As drawn by programs that join Bezier curves and keep their knots apart: between two nearly equal knots there is a span so short that the
    /// rounding of its points is noise in its speed.</summary>
    [Fact]
    public void Knots_that_are_hardly_apart_are_measured_in_time()
    {
        var knots = Enumerable.Range(0, 65).SelectMany(i => i is 0 or 64 ? new double[] { i, i, i, i } : [i, i, i, i + 1e-7]);
        var points = Enumerable.Range(0, 256).Select(i => (i - (i / 4)) / 30.0).SelectMany(turn => new (int, object)[] { (10, 54.3 + Math.Cos(turn)), (20, 12.3 + Math.Sin(turn)) });
        var file = DxfText.WithEntities([(0, "SPLINE"), (71, 3), .. knots.Select(knot => (40, (object)knot)), .. points]).ToAscii();

        Assert.Equal(192.0 / 30.0, DrawingSummary.From(DxfReading.Of(file)).Length.Spline, 1e-2);
        Assert.Empty(CrossCheck.Read(file).DifferencesFrom(DrawingSummary.From(DxfReading.Of(file))));
    }

    /// <summary>A double knot whose second value was rounded down is one double knot; it does not make the other knots unusable.</summary>
    [Theory]
    [InlineData(0.5, 0.49999999999, 1.0)]
    [InlineData(0.5, 0.5, 0.99999999999)]
    public void A_knot_that_falls_by_rounding_is_one_with_the_knot_before_it(double first, double second, double last)
    {
        (int, object)[] points = [(10, 0), (20, 0), (10, 0), (20, 9), (10, 3), (20, 3), (10, 3), (20, 0), (10, 4), (20, 0), (10, 5), (20, 5)];
        Drawing With(params double[] knots) => DxfReading.Entities([(0, "SPLINE"), (71, 3), .. knots.Select(knot => (40, (object)knot)), .. points]);
        var rounded = With(0, 0, 0, 0, first, second, 1, 1, 1, last);

        Assert.Empty(DxfReading.Ids(rounded));
        Assert.Equal(With(0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1).Curves[0].PlanLength, rounded.Curves[0].PlanLength, 1e-9);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-2)]
    [InlineData(4)]
    [InlineData(100)]
    public void A_degree_that_makes_no_curve_is_refused(int degree) =>
        Assert.Equal(["DXF0034"], DxfReading.Ids(DxfReading.Entities([(0, "SPLINE"), (71, degree), .. Spline.Where(pair => pair.Item1 is 10 or 20)])));

    [Fact]
    public void A_weight_that_is_no_number_costs_that_spline_and_no_other()
    {
        var drawing = DxfReading.Entities([.. Spline, (41, "NaN"), .. Ellipse]);

        Assert.Equal((1, 1), (drawing.Entities.Count, drawing.Balance.Refused.Count));
    }

    [Fact]
    public void A_long_spline_of_high_degree_ends_in_time()
    {
        const int Points = 1_000;
        var points = Enumerable.Range(0, Points).SelectMany(i => new (int, object)[] { (10, (double)i), (20, i % 7 * 1.5) });
        var drawing = DxfReading.Entities([(0, "SPLINE"), (71, 25), .. points]);

        Assert.True(drawing.Curves[0].PlanLength > Points - 1);
    }

    private static Drawing Inserting(ReadOnlySpan<(int, object)> content, params ReadOnlySpan<(int, object)> entities) => DxfReading.Of(new DxfText()
        .Header("AC1015", 4).Section("BLOCKS", [(0, "BLOCK"), (2, "B"), .. content, (0, "ENDBLK")]).Section("ENTITIES", entities).End());
}
