using System.Globalization;
using System.Text;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;

namespace Engraver.Core.Plots;

/// <summary>Writes segments as the d attribute of an SVG path; arcs stay arcs.</summary>
internal static class SvgPath
{
    /// <summary>Largest distance between a curve and the arcs drawn for it, picture units.</summary>
    private const double CurveNearness = 0.05;

    /// <summary>Segments that join become one pen stroke; a jump starts a new one.</summary>
    public static string Format(IReadOnlyList<Segment> segments, PlotFrame frame)
    {
        var path = new StringBuilder();
        string? pen = null;
        foreach (var segment in segments.SelectMany(segment => Drawable(segment, frame)))
        {
            var start = Pair(frame.Place(segment.Start));
            if (start != pen) path.Append('M').Append(start);
            if (segment.Kind == SegmentKind.Line) path.Append('L').Append(Pair(frame.Place(segment.End)));
            else AppendArc(path, segment, frame);
            pen = Pair(frame.Place(segment.End));
        }

        return path.ToString();
    }

    /// <summary>Ellipses and splines as arcs, which SVG has, with an error too small to see.</summary>
    public static IReadOnlyList<Segment> Drawable(Segment segment, PlotFrame frame) =>
        segment.IsFreeCurve ? BiarcFit.Fit(segment.Curve, CurveNearness / frame.Scale) : [segment];

    public static string Number(double value) => NumberText.RoundedWithoutMinusZero(value, 3);

    public static string Pair(Point2D place) => $"{Number(place.X)},{Number(place.Y)}";

    /// <summary>Writes an arc in two halves, because SVG cannot draw a full turn, and nearly full turns lose their direction by rounding. Counter-clockwise is
    /// sweep flag 0 with y down.</summary>
    private static void AppendArc(StringBuilder path, Segment segment, PlotFrame frame)
    {
        var radius = Number(segment.Arc.Radius * frame.Scale);
        var flag = segment.Arc.Sweep.Degrees > 0.0 ? 0 : 1;
        foreach (var end in new[] { segment.PointAt(0.5), segment.End })
        {
            path.Append(CultureInfo.InvariantCulture, $"A{radius},{radius} 0 0 {flag} {Pair(frame.Place(end))}");
        }
    }
}
