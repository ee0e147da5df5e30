using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Reports;

/// <summary>Text report of objects of a drawing, in drawing units.</summary>
public static class EntityText
{
    /// <summary>One line for each object and for each of its parts; of a text its string and form.</summary>
    /// <param name="entities">Indices into the entities of the shown drawing.</param>
    public static void Write(Drawing drawing, IEnumerable<int> entities, DisplayPrecision figures, TextWriter output)
    {
        var shown = ShownDrawing.Of(drawing);
        foreach (var index in entities)
        {
            var entity = shown.Entities[index];
            List<string> facts = [entity.Type.ToDxfName()];
            if (shown.SourceOf(index).Handle is { } handle) facts.Add(Wording.Get("EntityText.Handle", handle));
            facts.Add(Wording.Get("EntityText.Layer", drawing.Layers[entity.Layer].Name));
            if (ShownDrawing.TextOf(drawing, index) is { } text)
            {
                output.WriteLine(string.Join(", ", facts));
                WriteText(drawing.Texts[text], figures, output);
                continue;
            }

            if (entity.Closed) facts.Add(Wording.Get("EntityText.Closed"));
            facts.Add(Wording.Get("EntityText.EntityLength", figures.FormatLength(LengthOf(drawing, index))));
            output.WriteLine(string.Join(", ", facts));
            foreach (var segment in DrawingPick.Segments(drawing, index)) output.WriteLine("    " + Describe(segment, figures));
        }
    }

    /// <summary>Summary of the objects.</summary>
    public static void WriteTogether(Drawing document, IReadOnlyCollection<int> entities, DisplayPrecision figures, TextWriter output)
    {
        var drawing = ShownDrawing.Of(document);
        var types = entities.GroupBy(index => drawing.Entities[index].Type).Select(group => Invariant($"{group.Count()} {group.Key.ToDxfName()}"));
        var layers = entities.Select(index => drawing.Layers[drawing.Entities[index].Layer].Name).Distinct().Order(StringComparer.Ordinal);
        output.WriteLine(Wording.Get("EntityText.Objects", CountText.Format(entities.Count, "Object"), string.Join(", ", types)));
        output.WriteLine(Wording.Get("EntityText.Layers", string.Join(", ", layers)));
        output.WriteLine(Wording.Get("EntityText.TotalLength", figures.FormatLength(entities.Sum(index => LengthOf(drawing, index))), drawing.Unit.Name));
        var box = DrawingPick.BoundsOf(drawing, entities);
        if (!box.IsEmpty) output.WriteLine(Wording.Get("EntityText.Extents", figures.FormatLength(box.MinX), figures.FormatLength(box.MinY), figures.FormatLength(box.MaxX), figures.FormatLength(box.MaxY)));
    }

    private static void WriteText(PlacedText text, DisplayPrecision figures, TextWriter output)
    {
        output.WriteLine("    " + Wording.Get("EntityText.String", text.Content.Replace('\n', ' ')));
        output.WriteLine("    " + Wording.Get("EntityText.TextForm", text.Style, figures.FormatLength(text.Height), figures.FormatDegrees(text.Rotation.Positive()), figures.FormatLength(text.Position.X), figures.FormatLength(text.Position.Y)));
    }

    private static double LengthOf(Drawing drawing, int index) => DrawingPick.Segments(drawing, index).Sum(segment => segment.Length);

    private static string Describe(Segment segment, DisplayPrecision figures)
    {
        var (from, to) = (segment.Start, segment.End);
        string[] ends = [figures.FormatLength(from.X), figures.FormatLength(from.Y), figures.FormatLength(to.X), figures.FormatLength(to.Y)];
        if (segment.IsFreeCurve) return Facts(segment.Kind == SegmentKind.Ellipse ? "EntityText.Ellipse" : "EntityText.Spline", [.. ends, Invariant($"{segment.Curve.Spans.Length}"), figures.FormatLength(segment.Length)]);
        if (segment.Kind == SegmentKind.Line) return Facts("EntityText.Line", ends);
        var arc = segment.Arc;
        return Facts(segment.Kind == SegmentKind.Circle ? "EntityText.Circle" : "EntityText.Arc", [.. ends, figures.FormatLength(arc.Centre.X), figures.FormatLength(arc.Centre.Y), figures.FormatLength(arc.Radius), figures.FormatDegrees(arc.Sweep)]);
    }

    private static string Facts(string name, string[] facts) => Wording.Get(name, [.. facts]);

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
