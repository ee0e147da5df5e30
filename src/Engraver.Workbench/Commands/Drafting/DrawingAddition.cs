using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>Appends new curves to a drawing: on the current layer (CLAYER), in its colour, with new handles.</summary>
internal static class DrawingAddition
{
    /// <summary>Commits the new curves as one undo step.</summary>
    /// <exception cref="CommandException">A coordinate is out of the range of a drawing.</exception>
    public static void Commit(CommandContext context, params IReadOnlyList<NewCurve> curves) => context.Commit(Add(context.Document.Current, curves));

    /// <summary>The state with the new curves and an empty selection.</summary>
    /// <param name="state">Its drawing must be open.</param>
    /// <exception cref="CommandException">A coordinate is out of the range of a drawing.</exception>
    public static DocumentState Add(DocumentState state, IReadOnlyList<NewCurve> curves)
    {
        var (drawing, layer) = CurrentLayer.FindOrAdd(state);
        var handle = drawing.HighestHandle();
        var (entities, parts, free) = (new List<DrawingEntity>(), new List<DrawingPart>(), new List<RationalCurve>(drawing.Curves));
        foreach (var curve in curves)
        {
            entities.Add(new DrawingEntity { Handle = ++handle, FirstPart = drawing.Parts.Count + parts.Count, PartCount = curve.Segments.Count, Layer = layer, Colour = DrawingColour.ByLayer, Type = curve.Type, Closed = curve.Closed });
            foreach (var segment in curve.Segments) parts.Add(PartOf(segment, drawing.Entities.Count + entities.Count - 1, free));
        }

        return state with { Drawing = drawing with { Entities = drawing.Entities.With([], entities), Parts = drawing.Parts.With([], parts), Curves = free.Count == drawing.Curves.Count ? drawing.Curves : free }, Selection = [] };
    }

    private static DrawingPart PartOf(in Segment segment, int entity, List<RationalCurve> free)
    {
        var box = segment.Bounds;
        if (!Drawing.Holds(box)) throw new CommandException(CommandFailure.Usage, Wording.Get("Drafting.OutOfRange", Drawing.LargestCoordinate));
        if (segment.Kind == SegmentKind.Line) return DrawingPart.Line(entity, segment.Start.X, segment.Start.Y, 0.0, segment.End.X, segment.End.Y, 0.0);
        if (!segment.IsFreeCurve) return DrawingPart.Arc(entity, segment.Arc, 0.0);
        free.Add(segment.Curve);
        return DrawingPart.FreeCurve(entity, segment.Kind, free.Count - 1);
    }
}
