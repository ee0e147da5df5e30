using Engraver.Core.Drawings;

namespace Engraver.Core.Sequencing;

/// <summary>Counts what is cut in the operator's units: a line or arc part is one, and so is an ellipse or spline, however many arcs approximate it.</summary>
/// <remarks>A spline that is divided into several strokes counts in the first, so that the strokes add up to the whole.</remarks>
internal sealed class CurveCount(Drawing? drawing)
{
    private readonly HashSet<int> _counted = [];

    /// <param name="entities">Of the moves of a stroke.</param>
    public int Add(IEnumerable<int> entities)
    {
        if (drawing is null) return entities.Count();
        var count = 0;
        foreach (var entity in entities)
        {
            if (drawing.Entities[entity].Type is not (CurveType.Ellipse or CurveType.Spline) || _counted.Add(entity)) count++;
        }

        return count;
    }
}
