using Avalonia;
using Engraver.App.Canvas.Flattening;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.App.Tests.Canvas.Flattening;

/// <summary>Chords are not visible: at any zoom the chords are within a quarter of a pixel of the curve, and the curve of the chords.</summary>
public class FlatnessTests
{
    private const double QuarterPixel = 0.25;

    /// <summary>As a fraction of the largest coordinate: for smaller pixels a double cannot represent the drawing itself.</summary>
    private const double FinestPixel = 1e-13;

    private static readonly Gen<double> s_zooms = Gen.Choose(-3, 6).Select(decade => Math.Pow(10.0, decade));

    [Property]
    public Property Arcs_at_every_zoom() => IsFlatAtEveryZoom(Arcs.Any.Generator.Select(arc => Segment.FromArc(arc)));

    [Property]
    public Property Circles_at_every_zoom() => IsFlatAtEveryZoom(Arcs.Any.Generator.Select(arc => Segment.FromArc(arc with { Sweep = Angle.FullTurn })));

    [Property]
    public Property Ellipses_at_every_zoom() => IsFlatAtEveryZoom(FreeCurves.Ellipses.Generator.Select(Segment.FromCurve));

    [Property]
    public Property Splines_at_every_zoom() => IsFlatAtEveryZoom(FreeCurves.Splines.Generator.Select(Segment.FromCurve));

    [Fact]
    public void A_circle_a_million_times_larger_than_the_screen_costs_a_few_chords()
    {
        var circle = Segment.FromArc(new ArcSegment(new Point2D(0.0, 0.0), 1000.0, Angle.Zero, Angle.FullTurn));
        var view = new CanvasView(new Point2D(1000.0, 0.0), 1e-6, new PixelSize(1600, 1000));

        var chords = Flattened(circle, view).Chords;

        Assert.InRange(chords.Count, 1, 8);
    }

    [Fact]
    public void What_lies_outside_is_left_out_and_a_long_line_is_cut()
    {
        var view = new CanvasView(Point2D.Origin, 1.0, new PixelSize(100, 100));

        Assert.Empty(Flattened(Segment.FromArc(new ArcSegment(new Point2D(500.0, 0.0), 100.0, Angle.Zero, Angle.FullTurn)), view).Chords);
        Assert.Empty(Flattened(Segment.FromLine(new Point2D(-1000.0, 200.0), new Point2D(1000.0, 200.0)), view).Chords);
        var line = Assert.Single(Flattened(Segment.FromLine(new Point2D(-1e9, 0.0), new Point2D(1e9, 0.0)), view).Chords);
        Assert.InRange(line.Length, 100.0, 140.0);
    }

    private static Property IsFlatAtEveryZoom(Gen<Segment> segments)
    {
        var cases = from segment in segments from zoom in s_zooms from along in Gen.Choose(0, 1000) select (segment, zoom, along / 1000.0);
        return Prop.ForAll(cases.ToArbitrary(), sample => IsFlat(sample.segment, sample.zoom, sample.Item3));
    }

    /// <summary>The view is centred on the curve; all points of the curve near it are on chords, and the middles of all chords are on the curve.</summary>
    private static bool IsFlat(Segment segment, double zoom, double along)
    {
        var box = segment.Bounds;
        var finest = FinestPixel * new[] { box.MinX, box.MinY, box.MaxX, box.MaxY }.Max(Math.Abs);
        var view = new CanvasView(segment.PointAt(along), Math.Max(finest, Math.Max(box.Width, box.Height) / 800.0 / zoom), new PixelSize(1600, 1000));
        var chords = Flattened(segment, view);
        if (chords.DistanceTo(new Point2D(800.0, 500.0)) >= QuarterPixel) return false;
        var window = new Bounds2D(0.0, 0.0, 1600.0, 1000.0);
        for (var i = 0; i <= 200; i++)
        {
            var place = view.ToPixels(segment.PointAt(Math.Clamp(along + ((i - 100) / 200.0 / zoom), 0.0, 1.0)));
            if (window.Contains(place) && chords.DistanceTo(place) >= QuarterPixel) return false;
        }

        return chords.Chords.TrueForAll(chord => segment.DistanceTo(view.ToDrawing(chord.PointAt(0.5))) < QuarterPixel * view.UnitsPerPixel);
    }

    private static ChordList Flattened(Segment segment, CanvasView view)
    {
        var chords = new ChordList();
        SegmentFlattener.Flatten(segment, view, ref chords);
        return chords;
    }
}
