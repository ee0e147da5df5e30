using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Reports;

/// <summary>What objects of a drawing are, for people, in drawing units.</summary>
public static class EntityText
{
    /// <summary>One line for each object, one more for each of its parts.</summary>
    public static void Write(Drawing drawing, IEnumerable<int> entities, TextWriter output)
    {
        foreach (var index in entities)
        {
            var entity = drawing.Entities[index];
            var handle = drawing.SourceOf(index).Handle is { } name ? $", handle {name}" : "";
            output.WriteLine(Invariant($"{entity.Type.ToDxfName()}{handle}, layer {drawing.Layers[entity.Layer].Name}{(entity.Closed ? ", closed" : "")}, length {LengthOf(drawing, index):0.######}"));
            foreach (var segment in DrawingPick.Segments(drawing, index)) output.WriteLine("    " + Describe(segment));
        }
    }

    /// <summary>The objects taken together.</summary>
    public static void WriteTogether(Drawing drawing, IReadOnlyCollection<int> entities, TextWriter output)
    {
        var types = entities.GroupBy(index => drawing.Entities[index].Type).Select(group => Invariant($"{group.Count()} {group.Key.ToDxfName()}"));
        var layers = entities.Select(index => drawing.Layers[drawing.Entities[index].Layer].Name).Distinct().Order(StringComparer.Ordinal);
        output.WriteLine(Invariant($"{entities.Count} objects: {string.Join(", ", types)}"));
        output.WriteLine($"layers: {string.Join(", ", layers)}");
        output.WriteLine(Invariant($"length {entities.Sum(index => LengthOf(drawing, index)):0.######} {drawing.Unit.Name}"));
        var box = DrawingPick.BoundsOf(drawing, entities);
        if (!box.IsEmpty) output.WriteLine(Invariant($"from {box.MinX:0.######},{box.MinY:0.######} to {box.MaxX:0.######},{box.MaxY:0.######}"));
    }

    private static double LengthOf(Drawing drawing, int index) => DrawingPick.Segments(drawing, index).Sum(segment => segment.Length);

    private static string Describe(Segment segment)
    {
        var ends = Invariant($"from {segment.Start.X:0.######},{segment.Start.Y:0.######} to {segment.End.X:0.######},{segment.End.Y:0.######}");
        if (segment.IsFreeCurve) return Invariant($"{(segment.Kind == SegmentKind.Ellipse ? "ellipse" : "spline")} {ends}, {segment.Curve.Spans.Length} spans, length {segment.Length:0.######}");
        return segment.Kind == SegmentKind.Line
            ? $"line {ends}"
            : Invariant($"{(segment.Kind == SegmentKind.Circle ? "circle" : "arc")} {ends}, centre {segment.Arc.Centre.X:0.######},{segment.Arc.Centre.Y:0.######}, radius {segment.Arc.Radius:0.######}, sweep {segment.Arc.Sweep.Degrees:0.######}");
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
