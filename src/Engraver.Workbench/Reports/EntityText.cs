using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Reports;

/// <summary>What objects of a drawing are, for people, in drawing units.</summary>
public static class EntityText
{
    /// <summary>One line for each object, one more for each of its parts.</summary>
    public static void Write(Drawing drawing, IEnumerable<int> entities, Figures figures, TextWriter output)
    {
        foreach (var index in entities)
        {
            var entity = drawing.Entities[index];
            var handle = drawing.SourceOf(index).Handle is { } name ? Wording.Get("EntityText.Handle", name) : "";
            output.WriteLine(Wording.Get("EntityText.LayerLength", entity.Type.ToDxfName(), handle, drawing.Layers[entity.Layer].Name, entity.Closed ? Wording.Get("EntityText.Closed") : "", figures.Length(LengthOf(drawing, index))));
            foreach (var segment in DrawingPick.Segments(drawing, index)) output.WriteLine("    " + Describe(segment, figures));
        }
    }

    /// <summary>The objects taken together.</summary>
    public static void WriteTogether(Drawing drawing, IReadOnlyCollection<int> entities, Figures figures, TextWriter output)
    {
        var types = entities.GroupBy(index => drawing.Entities[index].Type).Select(group => Invariant($"{group.Count()} {group.Key.ToDxfName()}"));
        var layers = entities.Select(index => drawing.Layers[drawing.Entities[index].Layer].Name).Distinct().Order(StringComparer.Ordinal);
        output.WriteLine(Wording.Get("EntityText.Objects", entities.Count, string.Join(", ", types)));
        output.WriteLine(Wording.Get("EntityText.Layers", string.Join(", ", layers)));
        output.WriteLine(Wording.Get("EntityText.Length", figures.Length(entities.Sum(index => LengthOf(drawing, index))), drawing.Unit.Name));
        var box = DrawingPick.BoundsOf(drawing, entities);
        if (!box.IsEmpty) output.WriteLine(From(new Point2D(box.MinX, box.MinY), new Point2D(box.MaxX, box.MaxY), figures));
    }

    private static double LengthOf(Drawing drawing, int index) => DrawingPick.Segments(drawing, index).Sum(segment => segment.Length);

    private static string From(Point2D start, Point2D end, Figures figures) => Wording.Get("EntityText.From", figures.Length(start.X), figures.Length(start.Y), figures.Length(end.X), figures.Length(end.Y));

    private static string Describe(Segment segment, Figures figures)
    {
        var ends = From(segment.Start, segment.End, figures);
        if (segment.IsFreeCurve) return Wording.Get("EntityText.SpansLength", segment.Kind == SegmentKind.Ellipse ? Wording.Get("EntityText.Ellipse") : Wording.Get("EntityText.Spline"), ends, segment.Curve.Spans.Length, figures.Length(segment.Length));
        return segment.Kind == SegmentKind.Line
            ? Wording.Get("EntityText.Line", ends)
            : Wording.Get("EntityText.CentreRadiusSweep", segment.Kind == SegmentKind.Circle ? Wording.Get("EntityText.Circle") : Wording.Get("EntityText.Arc"), ends, figures.Length(segment.Arc.Centre.X), figures.Length(segment.Arc.Centre.Y), figures.Length(segment.Arc.Radius), figures.Degrees(segment.Arc.Sweep));
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
