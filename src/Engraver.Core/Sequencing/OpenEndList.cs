using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing;

/// <summary>The discontinuities of a chained table in the operator's terms. Each is created on demand: there can be two million of them, of which a screen
/// shows a few.</summary>
public sealed class OpenEndList : IndexedList<OpenEnd>
{
    private readonly ContourEnds _ends;
    private readonly Func<int, int> _entityOf;
    private readonly Drawing? _drawing;
    private readonly double _joined;

    internal OpenEndList(ChainedTable chained, SequencingOptions options) =>
        (_ends, _entityOf, _drawing, _joined) = (chained.Chain.Discontinuities, EntitiesOf(chained), chained.Drawing, options.JoinTolerance);

    public override int Count => _ends.Count;

    protected override OpenEnd ItemAt(int index)
    {
        var end = _ends[index];
        var nearest = end.NearestRow < 0 ? -1 : _entityOf(end.NearestRow);
        var rule = end.Gap > _joined && end.Gap < ContourEnds.WidestGap ? SequencingRules.SmallGap : SequencingRules.OpenEnds;
        return new OpenEnd(end.Place, _entityOf(end.Row), end.Gap, nearest, nearest < 0 ? null : _drawing?.SourceOf(nearest).Handle, rule.Id);
    }

    /// <summary>Position of one of the ends, millimetres.</summary>
    public Point2D PlaceOf(int index) => _ends.PlaceOf(index);

    /// <summary>Looks up the entity without a separate table of the kept rows.</summary>
    private static Func<int, int> EntitiesOf(ChainedTable chained)
    {
        if (ReferenceEquals(chained.Kept, chained.Analysed)) return chained.Analysed.EntityIndexOf;
        var entities = new int[chained.Kept.Count];
        for (var row = 0; row < entities.Length; row++) entities[row] = chained.Kept.EntityIndexOf(row);
        return row => entities[row];
    }
}
