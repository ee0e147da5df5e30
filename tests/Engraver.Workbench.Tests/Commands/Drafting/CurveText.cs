using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Tests.Commands.Drafting;

/// <summary>The curves of a drawing in short: <c>Line 0,0 10,0</c>, <c>Arc 5,5 r4 from 350 by 110</c>, a polyline as its parts.</summary>
internal static class CurveText
{
    /// <summary>Every curve, in order.</summary>
    public static string[] Of(Drawing? drawing) => drawing is null ? [] : [.. Enumerable.Range(0, drawing.Entities.Count).Select(index => Of(drawing, index))];

    private static string Of(Drawing drawing, int index)
    {
        var entity = drawing.Entities[index];
        var parts = string.Join(" ", DrawingPick.Segments(drawing, index).Select(Of));
        return $"{entity.Type} {(entity.Closed && entity.Type == CurveType.LwPolyline ? "closed " : "")}{parts}";
    }

    private static string Of(Segment segment) => segment.Kind switch
    {
        SegmentKind.Line => $"({At(segment.Start)} {At(segment.End)})",
        SegmentKind.Circle => $"({At(segment.Arc.Centre)} r{Show(segment.Arc.Radius)})",
        SegmentKind.Arc => $"({At(segment.Arc.Centre)} r{Show(segment.Arc.Radius)} from {Show(segment.Arc.Start.Positive().Degrees)} by {Show(segment.Arc.Sweep.Degrees)})",
        _ => $"({segment.Kind} {At(segment.Start)} {At(segment.PointAt(0.5))} {At(segment.End)})",
    };

    private static string At(Point2D place) => $"{Show(place.X)},{Show(place.Y)}";

    private static string Show(double value) => (Math.Round(value, 6) + 0.0).ToString("0.######", CultureInfo.InvariantCulture);
}
