using Engraver.Core.Drawings;

namespace Engraver.Core.Sequencing;

/// <summary>Counts the cut curves in the operator's units: a line or arc part counts as one, as does an ellipse or spline, independent of the number of arcs
/// that approximate it.</summary>
/// <remarks>A spline that is divided into several strokes counts in the first, so that the sum over the strokes is the total.</remarks>
internal sealed class CurveCount
{
    private readonly Drawing? _drawing;
    private readonly HashSet<int> _counted = [];

    public CurveCount(Drawing? drawing) => _drawing = drawing is not null && HasCurves(drawing) ? drawing : null; // without curves the entities need not be looked up

    /// <param name="moves">Moves of a stroke.</param>
    public int Add(StrokeMoveView moves)
    {
        if (_drawing is null) return moves.Count;
        var count = 0;
        for (var i = 0; i < moves.Count; i++)
        {
            var entity = moves.EntityOf(i);
            if (!IsCurve(_drawing, entity) || _counted.Add(entity)) count++;
        }

        return count;
    }

    private static bool IsCurve(Drawing drawing, int entity) => drawing.Entities[entity].Type is CurveType.Ellipse or CurveType.Spline;

    private static bool HasCurves(Drawing drawing)
    {
        for (var entity = 0; entity < drawing.Entities.Count; entity++)
        {
            if (IsCurve(drawing, entity)) return true;
        }

        return false;
    }
}
