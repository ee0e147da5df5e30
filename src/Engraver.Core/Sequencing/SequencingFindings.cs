using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.ArcRecovery;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Core.Sequencing;

/// <summary>Collects the findings of sequencing, in the operator's terms.</summary>
internal sealed class SequencingFindings(Drawing? drawing, SequencingOptions options, IReadOnlyList<Diagnostic>? earlier = null)
{
    /// <summary>Maximum number of listed findings of each rule; the rest are counted.</summary>
    private const int ShownPerRule = 100;

    private readonly List<Diagnostic> _diagnostics = [.. earlier ?? []];
    private readonly Dictionary<DiagnosticRule, int> _counts = new(ReferenceEqualityComparer.Instance);

    public IReadOnlyList<Diagnostic> Diagnostics => _diagnostics;

    /// <param name="analysed">Table before the removal.</param>
    /// <param name="kept">Remaining rows, ascending; at least one is missing.</param>
    public void AddDuplicates(EntityTable analysed, ReadOnlySpan<int> kept)
    {
        var first = 0;
        while (first < kept.Length && kept[first] == first) first++;
        var entity = analysed.EntityIndexOf(first);
        var handle = HandleOf(entity);
        var text = handle is null ? "SequencingFindings.DuplicatesWithoutHandle" : null;
        Add(SequencingRules.DuplicatesRemoved.At(SourceOf(entity), FactText.Of(analysed.Count - kept.Length, 6), handle ?? "") with { TextName = text });
    }

    public void AddArcs(ArcRecoveryResult recovered)
    {
        foreach (var (row, lines, deviation) in recovered.Arcs)
        {
            var arc = recovered.Table[row];
            var rule = arc.Kind == SegmentKind.Circle ? SequencingRules.CircleRecovered : SequencingRules.ArcRecovered;
            Add(rule, arc.EntityIndex, arc.StartPoint, FactText.Of(lines, 6), FactText.Of(arc.StartPoint.X, 6), FactText.Of(arc.StartPoint.Y, 6), FactText.Of(arc.Radius, 6), FactText.Of(deviation, 6));
        }
    }

    public void AddChain(ChainResult chain, EntityTable table, ReadOnlySpan<Segment> segments)
    {
        if (table.Count == 0 && drawing is not { HasErrors: true, Entities.Count: 0 }) _diagnostics.Add(SequencingRules.NothingToCut.At(default));
        if (chain.Branches > 0) _diagnostics.Add(SequencingRules.Branches.At(default, FactText.Of(chain.Branches, 6)));
        AddShortSegments(table, segments);
        var ends = chain.Discontinuities;
        var nearby = ends.FindNearby(options.JoinTolerance, ContourEnds.WidestGap, ShownPerRule);
        foreach (var end in nearby.Measured) AddSmallGap(end, table);
        if (nearby.Count > nearby.Measured.Count) _counts[SequencingRules.SmallGap] = nearby.Count;
        if (nearby.FirstFar < 0) return;
        var (place, row) = (ends.PlaceOf(nearby.FirstFar), ends.RowOf(nearby.FirstFar));
        Add(SequencingRules.OpenEnds, table.EntityIndexOf(row), place, FactText.Of(ContourEnds.WidestGap, 6), FactText.Of(ends.Count - nearby.Count, 6), FactText.Of(place.X, 6), FactText.Of(place.Y, 6));
    }

    /// <summary>Reports the rules that have more findings than are listed. Must be called once, after all findings.</summary>
    public void SumUp()
    {
        foreach (var (rule, count) in _counts.Where(entry => entry.Value > ShownPerRule).OrderBy(entry => entry.Key.Id, StringComparer.Ordinal))
        {
            _diagnostics.Add(SequencingRules.MoreOfTheSame.At(default, rule.Id, FactText.Of(count, 6), FactText.Of(ShownPerRule, 6)));
        }
    }

    /// <param name="wish">The operator's request.</param>
    /// <param name="enter">The entity that is cut for the request.</param>
    public void AddEntry(EntryRequest wish, EntryRequest enter, StrokeEntry? entry, ReadOnlySpan<int> inside)
    {
        if (enter != wish && (wish, enter) is (EntryRequest.AtEntity { EntityIndex: var named }, EntryRequest.AtEntity { EntityIndex: var standIn }))
            AddEntryReplaced(named, HandleOf(named), HandleOf(standIn));
        if (entry is not { } found)
        {
            _diagnostics.Add(SequencingRules.EntryNotFound.At(default));
            return;
        }

        var within = inside.Count(found.Contour);
        if (within > 0) _diagnostics.Add(SequencingRules.EntryWaits.At(default, FactText.Of(within, 6)));
    }

    private void AddEntryReplaced(int named, string? handle, string? other)
    {
        var text = handle is null || other is null ? "SequencingFindings.EntryWithoutHandle" : null;
        Add(SequencingRules.EntryStandsIn.At(SourceOf(named), handle ?? "", other ?? "") with { TextName = text });
    }

    private void AddSmallGap(Discontinuity end, EntityTable table)
    {
        var nearest = HandleOf(table.EntityIndexOf(end.NearestRow));
        var text = nearest is null ? "SequencingFindings.GapWithoutHandle" : null;
        Add(SequencingRules.SmallGap.At(SourceOf(table.EntityIndexOf(end.Row)), FactText.Of(end.Place.X, 6), FactText.Of(end.Place.Y, 6), FactText.Of(end.Gap ?? 0.0, 6), nearest ?? "") with { Place = end.Place, TextName = text });
    }

    private void AddShortSegments(EntityTable table, ReadOnlySpan<Segment> segments)
    {
        var (count, first) = (0, 0);
        for (var row = segments.Length - 1; row >= 0; row--)
        {
            if (segments[row].Length > options.JoinTolerance) continue;
            (count, first) = (count + 1, row);
        }

        if (count == 0) return;
        var place = segments[first].Start;
        Add(SequencingRules.ShortSegments, table.EntityIndexOf(first), place, FactText.Of(options.JoinTolerance, 6), FactText.Of(count, 6), FactText.Of(place.X, 6), FactText.Of(place.Y, 6));
    }

    private void Add(DiagnosticRule rule, int entity, Point2D? place, params ReadOnlySpan<string> facts) => Add(rule.At(SourceOf(entity), facts) with { Place = place });

    private void Add(Diagnostic found)
    {
        var count = _counts[found.Rule] = _counts.GetValueOrDefault(found.Rule) + 1;
        if (count <= ShownPerRule) _diagnostics.Add(found);
    }

    private SourceRef SourceOf(int entity) => drawing?.SourceOf(entity) ?? default;

    private string? HandleOf(int entity) => SourceOf(entity).Handle;
}
