using System.Text;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Dxf.Writing;

/// <summary>Ellipses and splines are written as such and read back as the same curve.</summary>
public class DxfCurveWriterTests
{
    [Property]
    public Property Every_elliptical_arc_reads_back_with_its_course_and_direction() =>
        Prop.ForAll(Numbers(), Numbers(), Numbers(), (centre, axes, angles) =>
        {
            var (major, minor) = (new Vector3D(3.0 + axes.A, axes.B, 0.0), new Vector3D(axes.C, 0.5 + (axes.D / 10.0), 0.0));
            if (Math.Abs((major.X * minor.Y) - (major.Y * minor.X)) < 0.05) return;
            var ellipse = new EllipseArc(new Vector3D(centre.A, centre.B, 0.0), major, minor, Angle.FromDegrees(angles.A * 30.0), Angle.FromDegrees(Sweep(angles.B)));
            AssertSame(ellipse.ToCurve(), CurveType.Ellipse);
        });

    [Theory]
    [InlineData(360.0)]
    [InlineData(-360.0)]
    public void A_whole_ellipse_keeps_where_it_starts_and_which_way_round_it_goes(double sweep) =>
        AssertSame(new EllipseArc(new Vector3D(5, -3, 0), new Vector3D(7, 2, 0), new Vector3D(-0.4, 1.4, 0), Angle.FromDegrees(70), Angle.FromDegrees(sweep)).ToCurve(), CurveType.Ellipse);

    /// <summary>The axes of a sliver vanish by rounding: it was written as NaN, which other programs cannot read.</summary>
    [Theory]
    [InlineData(1e-8)]
    [InlineData(1e-9)]
    [InlineData(1e-7)]
    [InlineData(1e-6)]
    [InlineData(1e-4)]
    [InlineData(1e-2)]
    public void A_sliver_of_an_ellipse_is_written_with_its_ends_and_without_a_number_that_is_none(double radians)
    {
        var curve = new EllipseArc(new Vector3D(423.71213738, -73.35906756, 0.0), new Vector3D(41.4999959, 0.01877599, 0.0), new Vector3D(-0.0184, 40.75, 0.0), Angle.Zero, Angle.FromRadians(radians)).ToCurve();
        var text = Written(new DxfSheet([], [new DxfSheetEntity(Segment.FromCurve(curve), "0", null, 0, 0)]));
        var drawing = DxfReading.Of(text);
        var found = drawing.SegmentOf(drawing.Parts[0]);

        Assert.DoesNotContain("NaN", text, StringComparison.Ordinal);
        Assert.Equal(0.0, found.Start.DistanceTo(curve.Start) + found.End.DistanceTo(curve.End), 1e-7);
        Assert.Equal(curve.PlanLength, found.Length, 1e-7 * curve.PlanLength + 1e-12);
    }

    [Fact]
    public void A_number_that_is_not_finite_stops_the_writing_and_names_the_entity()
    {
        var bad = new DxfSheetEntity(Segment.FromLine(default, new Point2D(double.PositiveInfinity, 1.0)), "0", null, 0, 0) { Source = new SourceRef(9, "3C") };

        var thrown = Assert.Throws<UnwritableEntityException>(() => Written(new DxfSheet([], [new DxfSheetEntity(Segment.FromLine(default, new Point2D(1, 0)), "0", null, 0, 0), bad])));

        Assert.Contains("3C", thrown.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Splines_read_back_exactly_rational_or_not_forwards_or_backwards()
    {
        var drawing = DxfReading.Entities([.. OddDrawings.Spline, .. OddDrawings.FitSpline, (0, "SPLINE"), (71, 2), (40, 0), (40, 0), (40, 0), (40, 1), (40, 3), (40, 3), (40, 3), (10, 0), (20, 0), (10, 1), (20, 4), (10, 5), (20, 4), (10, 6), (20, 0)]);
        foreach (var curve in drawing.Curves)
        {
            AssertSame(curve, CurveType.Spline);
            AssertSame(curve.Reversed(), CurveType.Spline);
        }
    }

    [Fact]
    public void A_layer_name_in_any_script_is_written_in_ascii_and_reads_back()
    {
        const string Name = "Größe 切断 \uD83D\uDE00";
        var text = Written(new DxfSheet([new DxfSheetLayer(Name, 3)], [new DxfSheetEntity(Segment.FromLine(default, new Point2D(1, 0)), Name, "cut", 1, 1)]));
        var drawing = DxfReading.Of(text);

        Assert.True(Ascii.IsValid(text));
        Assert.Equal(Name, drawing.Layers[drawing.Entities[0].Layer].Name);
        Assert.Contains("\\U+00F6", text, StringComparison.Ordinal);
    }

    /// <summary>15 to 315 degrees, in either direction.</summary>
    private static double Sweep(double number) => number < 0.0 ? (number * 30.0) - 15.0 : (number * 30.0) + 15.0;

    private static void AssertSame(RationalCurve curve, CurveType type)
    {
        var drawing = DxfReading.Of(Written(new DxfSheet([], [new DxfSheetEntity(Segment.FromCurve(curve), "0", null, 0, 0)])));
        Assert.DoesNotContain(drawing.Diagnostics, found => found.Id != "DXF0041");
        Assert.Equal(type, Assert.Single(DxfReading.Curves(drawing)).Type);
        var found = drawing.SegmentOf(drawing.Parts[0]);
        var tolerance = 1e-7 * (1.0 + curve.PlanLength);
        Assert.Equal(curve.PlanLength, found.Length, tolerance);
        Assert.True(curve.Start.IsNear(found.Start, tolerance) && curve.End.IsNear(found.End, tolerance), $"{curve.Start} {found.Start} {curve.End} {found.End}");
        Assert.True((curve.StartTangent * (1.0 / curve.StartTangent.Length)).Dot(found.StartTangent * (1.0 / found.StartTangent.Length)) > 1.0 - 1e-6, "it sets off in another direction");
        for (var i = 1; i < 8; i++) Assert.True(found.DistanceTo(curve.PointAt(i / 8.0)) <= tolerance, $"{i}");
    }

    private static string Written(DxfSheet sheet)
    {
        using var output = new StringWriter();
        DxfWriter.Write(sheet, output);
        return output.ToString();
    }

    private static Arbitrary<(double A, double B, double C, double D)> Numbers()
    {
        var number = Gen.Choose(-1000, 1000).Select(n => n / 100.0);
        return Arb.From(number.SelectMany(a => number.SelectMany(b => number.SelectMany(c => Gen.Choose(0, 1000).Select(d => (a, b, c / 10.0, d / 100.0))))));
    }
}
