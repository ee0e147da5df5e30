using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Properties;

/// <summary>Closes polylines by a line from their last vertex to the first, and opens them by removing the part between these.</summary>
internal static class ClosedProperty
{
    public static string Format(bool isClosed) => Wording.Get(isClosed ? "Property.Yes" : "Property.No");

    /// <summary>Parses yes or no in the current language or in English; a prefix is sufficient.</summary>
    /// <exception cref="CommandException">The text is neither.</exception>
    public static bool Parse(string typed)
    {
        if (StartsWithAny(typed, Format(true), "Yes")) return true;
        return StartsWithAny(typed, Format(false), "No") ? false : throw new CommandException(CommandFailure.Usage, Wording.Get("ChProp.NotYesOrNo", typed.Trim(), Format(true), Format(false)));
    }

    /// <exception cref="CommandException">A polyline is a single line.</exception>
    public static Drawing Apply(Drawing drawing, IReadOnlyList<ObjectFacts> polylines, bool closed)
    {
        var changing = polylines.Where(facts => facts.Entity.Closed != closed).ToDictionary(facts => facts.Index);
        if (changing.Count == 0) return drawing;
        if (closed && changing.Values.FirstOrDefault(facts => facts.Line is not null) is { } line) throw new CommandException(CommandFailure.Usage, Wording.Get("ChProp.SingleLineCannotClose", line.Handle));
        var rebuilt = new DrawingRebuild(drawing);
        for (var index = 0; index < drawing.Entities.Count; index++)
        {
            if (changing.TryGetValue(index, out var facts)) rebuilt.Change(index, facts.Entity.Type, closed, closed ? Closed(drawing, index) : Opened(drawing, index));
            else rebuilt.Keep(index);
        }

        return rebuilt.Finish();
    }

    private static bool StartsWithAny(string typed, params string[] words) => typed.Trim() is { Length: > 0 } word && Array.Exists(words, whole => whole.StartsWith(word, StringComparison.OrdinalIgnoreCase));

    private static List<DrawingPart> Closed(Drawing drawing, int index)
    {
        var parts = DrawingRebuild.PartsOf(drawing, index);
        if (parts.Count == 0) return parts;
        var (start, end) = (Place(drawing, parts[0], atEnd: false), Place(drawing, parts[^1], atEnd: true));
        if (start != end) parts.Add(DrawingPart.Line(0, end.X, end.Y, end.Z, start.X, start.Y, start.Z));
        return parts;
    }

    private static List<DrawingPart> Opened(Drawing drawing, int index)
    {
        var parts = DrawingRebuild.PartsOf(drawing, index);
        if (parts.Count > 1) parts.RemoveAt(parts.Count - 1);
        return parts;
    }

    private static Vector3D Place(Drawing drawing, in DrawingPart part, bool atEnd)
    {
        var segment = drawing.SegmentOf(part);
        var plan = atEnd ? segment.End : segment.Start;
        if (!part.IsFreeCurve) return new Vector3D(plan.X, plan.Y, part.Kind == SegmentKind.Line && atEnd ? part.F : part.C);
        var span = drawing.Curves[part.CurveIndex].Spans[atEnd ? ^1 : 0];
        return new Vector3D(plan.X, plan.Y, span.Z(atEnd ? span.Degree : 0));
    }
}
