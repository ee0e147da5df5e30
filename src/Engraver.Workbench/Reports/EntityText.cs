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
            var handle = drawing.SourceOf(index).Handle is { } name ? Wording.Get("EntityText.Handle", name) : "";
            output.WriteLine(Wording.Get("EntityText.LayerLength", entity.Type.ToDxfName(), handle, drawing.Layers[entity.Layer].Name, entity.Closed ? Wording.Get("EntityText.Closed") : "", LengthOf(drawing, index)));
            foreach (var segment in DrawingPick.Segments(drawing, index)) output.WriteLine("    " + Describe(segment));
        }
    }

    /// <summary>The objects taken together.</summary>
    public static void WriteTogether(Drawing drawing, IReadOnlyCollection<int> entities, TextWriter output)
    {
        var types = entities.GroupBy(index => drawing.Entities[index].Type).Select(group => Invariant($"{group.Count()} {group.Key.ToDxfName()}"));
        var layers = entities.Select(index => drawing.Layers[drawing.Entities[index].Layer].Name).Distinct().Order(StringComparer.Ordinal);
        output.WriteLine(Wording.Get("EntityText.Objects", entities.Count, string.Join(", ", types)));
        output.WriteLine(Wording.Get("EntityText.Layers", string.Join(", ", layers)));
        output.WriteLine(Wording.Get("EntityText.Length", entities.Sum(index => LengthOf(drawing, index)), drawing.Unit.Name));
        var box = DrawingPick.BoundsOf(drawing, entities);
        if (!box.IsEmpty) output.WriteLine(Wording.Get("EntityText.From", box.MinX, box.MinY, box.MaxX, box.MaxY));
    }

    private static double LengthOf(Drawing drawing, int index) => DrawingPick.Segments(drawing, index).Sum(segment => segment.Length);

    private static string Describe(Segment segment)
    {
        var ends = Wording.Get("EntityText.From", segment.Start.X, segment.Start.Y, segment.End.X, segment.End.Y);
        if (segment.IsFreeCurve) return Wording.Get("EntityText.SpansLength", segment.Kind == SegmentKind.Ellipse ? Wording.Get("EntityText.Ellipse") : Wording.Get("EntityText.Spline"), ends, segment.Curve.Spans.Length, segment.Length);
        return segment.Kind == SegmentKind.Line
            ? Wording.Get("EntityText.Line", ends)
            : Wording.Get("EntityText.CentreRadiusSweep", segment.Kind == SegmentKind.Circle ? Wording.Get("EntityText.Circle") : Wording.Get("EntityText.Arc"), ends, segment.Arc.Centre.X, segment.Arc.Centre.Y, segment.Arc.Radius, segment.Arc.Sweep.Degrees);
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
