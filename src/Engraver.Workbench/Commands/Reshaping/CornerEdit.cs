using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>Two objects, or two neighbouring parts of a polyline, joined by FILLET or CHAMFER.</summary>
internal sealed class CornerEdit
{
    private readonly CornerSide _first;
    private readonly CornerSide _second;
    private readonly Fillet _fillet;
    private readonly bool _trims;

    private CornerEdit(CornerSide first, CornerSide second, Fillet fillet, bool trims) => (_first, _second, _fillet, _trims) = (first, second, fillet, trims);

    /// <summary>The segment between both.</summary>
    public IReadOnlyList<Segment> Preview => _fillet.Between is { } between ? [between] : [];

    /// <returns>Null if they cannot be joined.</returns>
    public static CornerEdit? Between(Drawing drawing, CornerSide first, CornerSide second, FilletSettings shape)
    {
        if (first == second || !AreJoinable(drawing, first, second)) return null;
        var fillet = shape.Of(first.SegmentIn(drawing), first.At, second.SegmentIn(drawing), second.At);
        if (fillet is null || (first.Entity == second.Entity && PolylineCorner.From(drawing, first.Entity, first.Part, second.Part, fillet) is null)) return null;
        return new CornerEdit(first, second, fillet, shape.TrimsSides);
    }

    /// <summary>Text key of the reason why two objects cannot be joined.</summary>
    public static string RefusalOf(Drawing drawing, CornerSide first, CornerSide second)
    {
        if (first.Entity == second.Entity && first.Part == second.Part) return "Fillet.SamePart";
        return AreJoinable(drawing, first, second) ? "Fillet.DoesNotFit" : "Fillet.WrongKind";
    }

    /// <summary>Commits one undo step.</summary>
    public void Commit(CommandContext context)
    {
        if (_trims && _first.Entity == _second.Entity) RoundedPolyline.With(context.Drawing, _first.Entity, PolylineCorner.From(context.Drawing, _first.Entity, _first.Part, _second.Part, _fillet)!.Value).Commit(context);
        else if (_trims && JoinedPolyline.Of(context.Drawing, _first, _second, _fillet) is { } joined) joined.Commit(context);
        else CommitSeparate(context);
    }

    /// <summary>Both remain separate objects, and the segment between them is a third one.</summary>
    private void CommitSeparate(CommandContext context)
    {
        var (drawing, layer) = LayerOf(context);
        var reshaped = new ReshapedDrawing(drawing);
        if (_trims) Set(reshaped, _first.Entity, _fillet.First);
        if (_trims) Set(reshaped, _second.Entity, _fillet.Second);
        if (_fillet.Between is { } between) reshaped.Add(_first.Entity, layer, between);
        var rebuilt = reshaped.Build();
        DrawingChange.Commit(context, rebuilt, reshaped.Places(rebuilt, [_first.Entity, _second.Entity]));
    }

    /// <summary>The common layer of both; otherwise the current layer.</summary>
    private (Drawing Drawing, int Layer) LayerOf(CommandContext context)
    {
        var entities = context.Drawing.Entities;
        return entities[_first.Entity].Layer == entities[_second.Entity].Layer ? (context.Drawing, entities[_first.Entity].Layer) : CurrentLayer.FindOrAdd(context.Document.Current);
    }

    private static void Set(ReshapedDrawing reshaped, int entity, FilletSide? side)
    {
        if (side is { Remaining: var kept } && !JoinedPolyline.IsUnbroken(reshaped.Drawing, entity)) reshaped.Set(entity, [[kept]]);
    }

    /// <summary>True for separate lines, arcs and circles and for lines and arcs of polylines; within one polyline only if the parts can form a
    /// corner.</summary>
    private static bool AreJoinable(Drawing drawing, CornerSide first, CornerSide second)
    {
        if (first.Entity == second.Entity) return PolylineCorner.AreJoinable(drawing, first.Entity, first.Part, second.Part);
        return IsRoundOrStraight(drawing, first) && IsRoundOrStraight(drawing, second);
    }

    private static bool IsRoundOrStraight(Drawing drawing, CornerSide side) =>
        drawing.Entities[side.Entity].Type is CurveType.Line or CurveType.Arc or CurveType.Circle or CurveType.LwPolyline or CurveType.Polyline && !side.SegmentIn(drawing).IsFreeCurve;
}

/// <summary>A picked part of an object.</summary>
/// <param name="Part">Index of the part, from 0.</param>
/// <param name="At">Pick point, drawing units.</param>
internal readonly record struct CornerSide(int Entity, int Part, Point2D At)
{
    /// <summary>The part at a point; null if there is none.</summary>
    public static CornerSide? Under(CommandContext context, Point2D place)
    {
        if (ObjectSelection.EntityAt(context, place) is not { } entity || ReshapedDrawing.PathOf(context.Drawing, entity) is not { } path) return null;
        return new CornerSide(entity, path.Nearest(place).Part, place);
    }

    public Segment SegmentIn(Drawing drawing) => drawing.SegmentOf(drawing.Parts[drawing.Entities[Entity].FirstPart + Part]);
}
