using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>Two objects, or two neighbouring parts of a polyline, joined by FILLET or CHAMFER.</summary>
internal sealed class Corner
{
    private readonly CornerSide _first;
    private readonly CornerSide _second;
    private readonly Fillet _fillet;
    private readonly bool _trims;

    private Corner(CornerSide first, CornerSide second, Fillet fillet, bool trims) => (_first, _second, _fillet, _trims) = (first, second, fillet, trims);

    /// <summary>What comes between the two.</summary>
    public IReadOnlyList<Segment> Shown => _fillet.Between is { } between ? [between] : [];

    /// <returns>Null when they cannot be joined so.</returns>
    public static Corner? Between(Drawing drawing, CornerSide first, CornerSide second, CornerShape shape)
    {
        if (first == second || !AreJoinable(drawing, first, second)) return null;
        var fillet = shape.Of(first.SegmentIn(drawing), first.At, second.SegmentIn(drawing), second.At);
        if (fillet is null || (first.Entity == second.Entity && PolylineCorner.From(drawing, first.Entity, first.Part, second.Part, fillet) is null)) return null;
        return new Corner(first, second, fillet, shape.Trims);
    }

    /// <summary>Name of the sentence for two that cannot be joined.</summary>
    public static string WhyNot(Drawing drawing, CornerSide first, CornerSide second)
    {
        if (first.Entity == second.Entity && first.Part == second.Part) return "Fillet.SamePart";
        return AreJoinable(drawing, first, second) ? "Fillet.DoesNotFit" : "Fillet.WrongKind";
    }

    /// <summary>One document step.</summary>
    public void Take(CommandContext context)
    {
        if (_trims && _first.Entity == _second.Entity) RoundedPolyline.With(context.Drawing, _first.Entity, PolylineCorner.From(context.Drawing, _first.Entity, _first.Part, _second.Part, _fillet)!.Value).Take(context);
        else if (_trims && JoinedPolyline.Of(context.Drawing, _first, _second, _fillet) is { } joined) joined.Take(context);
        else TakeApart(context);
    }

    /// <summary>Both stay objects of their own, and what comes between them is a third.</summary>
    private void TakeApart(CommandContext context)
    {
        var (drawing, layer) = LayerOf(context);
        var reshaped = new ReshapedDrawing(drawing);
        if (_trims) Set(reshaped, _first.Entity, _fillet.First);
        if (_trims) Set(reshaped, _second.Entity, _fillet.Second);
        if (_fillet.Between is { } between) reshaped.Add(_first.Entity, layer, between);
        var rebuilt = reshaped.Build();
        DrawingChange.Take(context, rebuilt, reshaped.Places(rebuilt, [_first.Entity, _second.Entity]));
    }

    /// <summary>The layer of both, where they have the same; else the current one.</summary>
    private (Drawing Drawing, int Layer) LayerOf(CommandContext context)
    {
        var entities = context.Drawing.Entities;
        return entities[_first.Entity].Layer == entities[_second.Entity].Layer ? (context.Drawing, entities[_first.Entity].Layer) : CurrentLayer.In(context.Document.Current);
    }

    private static void Set(ReshapedDrawing reshaped, int entity, FilletSide? side)
    {
        if (side is { Kept: var kept } && !JoinedPolyline.StaysWhole(reshaped.Drawing, entity)) reshaped.Set(entity, [[kept]]);
    }

    /// <summary>Lines, arcs and circles by themselves, and the lines and arcs of polylines; of one polyline those between which a corner can be.</summary>
    private static bool AreJoinable(Drawing drawing, CornerSide first, CornerSide second)
    {
        if (first.Entity == second.Entity) return PolylineCorner.AreJoinable(drawing, first.Entity, first.Part, second.Part);
        return IsRoundOrStraight(drawing, first) && IsRoundOrStraight(drawing, second);
    }

    private static bool IsRoundOrStraight(Drawing drawing, CornerSide side) =>
        drawing.Entities[side.Entity].Type is CurveType.Line or CurveType.Arc or CurveType.Circle or CurveType.LwPolyline or CurveType.Polyline && !side.SegmentIn(drawing).IsFreeCurve;
}

/// <summary>A part of an object that was picked.</summary>
/// <param name="Part">Which of its parts, from 0.</param>
/// <param name="At">Where it was picked, drawing units.</param>
internal readonly record struct CornerSide(int Entity, int Part, Point2D At)
{
    /// <summary>The part under a place; null when there is nothing.</summary>
    public static CornerSide? Under(CommandContext context, Point2D place)
    {
        if (ObjectSelection.At(context, place) is not { } entity || ReshapedDrawing.PathOf(context.Drawing, entity) is not { } path) return null;
        return new CornerSide(entity, path.Nearest(place).Part, place);
    }

    public Segment SegmentIn(Drawing drawing) => drawing.SegmentOf(drawing.Parts[drawing.Entities[Entity].FirstPart + Part]);
}

/// <summary>What FILLET or CHAMFER makes of a corner. Lengths in drawing units.</summary>
/// <param name="Radius">Of the arc; 0: a corner.</param>
/// <param name="First">What the chamfer cuts off the first line.</param>
/// <param name="Second">And off the second.</param>
/// <param name="Bevels">A chamfer, no arc.</param>
/// <param name="Trims">Both objects are cut or lengthened to the joint; else they stay.</param>
internal sealed record CornerShape(double Radius, double First, double Second, bool Bevels, bool Trims)
{
    public Fillet? Of(Segment first, Point2D pickedFirst, Segment second, Point2D pickedSecond) => Bevels
        ? Fillet.Bevel(first, pickedFirst, second, pickedSecond, First, Second)
        : Fillet.Create(first, pickedFirst, second, pickedSecond, Radius);
}
