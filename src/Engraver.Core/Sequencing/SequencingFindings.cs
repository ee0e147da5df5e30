using System.Globalization;
using System.Runtime.InteropServices;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.ArcRecovery;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Core.Sequencing;

/// <summary>Collects what sequencing has to say, in the operator's terms.</summary>
internal sealed class SequencingFindings(Drawing? drawing, SequencingOptions options, IReadOnlyList<Diagnostic>? earlier = null)
{
    /// <summary>Of each rule so many are listed; the rest are counted.</summary>
    private const int ShownPerRule = 100;

    private readonly List<Diagnostic> _diagnostics = [.. earlier ?? []];
    private readonly Dictionary<DiagnosticRule, int> _counts = new(ReferenceEqualityComparer.Instance);

    public IReadOnlyList<Diagnostic> Diagnostics => _diagnostics;

    /// <param name="analysed">Before removal.</param>
    /// <param name="kept">Rows that stay, ascending; at least one is missing.</param>
    public void AddDuplicates(EntityTable analysed, ReadOnlySpan<int> kept)
    {
        var first = 0;
        while (first < kept.Length && kept[first] == first) first++;
        var entity = analysed.EntityIndexOf(first);
        Add(SequencingRules.DuplicatesRemoved, entity, null, Number(analysed.Count - kept.Length), HandleOf(entity) ?? Wording.Get("SequencingFindings.WithoutHandle"));
    }

    public void AddArcs(ArcRecoveryResult recovered)
    {
        foreach (var (row, lines, deviation) in recovered.Arcs)
        {
            var arc = recovered.Table[row];
            var rule = arc.Kind == SegmentKind.Circle ? SequencingRules.CircleRecovered : SequencingRules.ArcRecovered;
            Add(rule, arc.EntityIndex, arc.StartPoint, Number(lines), Number(arc.StartPoint.X), Number(arc.StartPoint.Y), Number(arc.Radius), Number(deviation));
        }
    }

    public void AddChain(ChainResult chain, EntityTable table, ReadOnlySpan<Segment> segments)
    {
        if (table.Count == 0 && drawing is not { HasErrors: true, Entities.Count: 0 }) _diagnostics.Add(SequencingRules.NothingToCut.At(default));
        if (chain.Branches > 0) _diagnostics.Add(SequencingRules.Branches.At(default, Number(chain.Branches)));
        AddShortSegments(table, segments);
        var (wide, first) = (0, default(Discontinuity));
        foreach (var end in chain.Discontinuities)
        {
            if (IsSuspicious(end)) AddSmallGap(end, table);
            else if (wide++ == 0) first = end;
        }

        if (wide == 0) return;
        Add(SequencingRules.OpenEnds, table.EntityIndexOf(first.Row), first.Place, Number(wide), Number(options.SuspiciousGap), Number(first.Place.X), Number(first.Place.Y));
    }

    /// <summary>Says of which rules there are more findings than are listed. To be called once, when all are in.</summary>
    public void SumUp()
    {
        foreach (var (rule, count) in _counts.Where(entry => entry.Value > ShownPerRule).OrderBy(entry => entry.Key.Id, StringComparer.Ordinal))
        {
            _diagnostics.Add(SequencingRules.MoreOfTheSame.At(default, rule.Id, Number(count), Number(ShownPerRule)));
        }
    }

    /// <param name="wish">What the operator named.</param>
    /// <param name="enter">What that is cut as.</param>
    public void AddEntry(EnterAt wish, EnterAt enter, StrokeEntry? entry, ReadOnlySpan<int> inside)
    {
        if (enter != wish && (wish, enter) is (EnterAt.AtEntity { EntityIndex: var named }, EnterAt.AtEntity { EntityIndex: var standIn }))
            Add(SequencingRules.EntryStandsIn, named, null, HandleOf(named) ?? Wording.Get("SequencingFindings.WithoutHandle"), HandleOf(standIn) ?? Wording.Get("SequencingFindings.WithoutHandle"));
        if (entry is not { } found)
        {
            _diagnostics.Add(SequencingRules.EntryNotFound.At(default));
            return;
        }

        var within = inside.Count(found.Contour);
        if (within > 0) _diagnostics.Add(SequencingRules.EntryWaits.At(default, Number(within)));
    }

    private static string Number(double value) => Math.Round(value, 6).ToString("0.######", CultureInfo.InvariantCulture);

    private bool IsSuspicious(in Discontinuity end) => OpenEndList.IsSuspicious(end, options.SuspiciousGap);

    private void AddSmallGap(Discontinuity end, EntityTable table)
    {
        if (!IsListed(SequencingRules.SmallGap)) return; // there may be two million of them
        var nearest = HandleOf(table.EntityIndexOf(end.NearestRow)) ?? Wording.Get("SequencingFindings.WithoutHandle");
        List(SequencingRules.SmallGap, table.EntityIndexOf(end.Row), end.Place, Number(end.Place.X), Number(end.Place.Y), Number(end.Gap ?? 0.0), nearest);
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
        Add(SequencingRules.ShortSegments, table.EntityIndexOf(first), place, Number(count), Number(options.JoinTolerance), Number(place.X), Number(place.Y));
    }

    private void Add(DiagnosticRule rule, int entity, Point2D? place, params ReadOnlySpan<string> facts)
    {
        if (IsListed(rule)) List(rule, entity, place, facts);
    }

    private void List(DiagnosticRule rule, int entity, Point2D? place, params ReadOnlySpan<string> facts) => _diagnostics.Add(rule.At(drawing?.SourceOf(entity) ?? default, facts) with { Place = place });

    /// <summary>Counts a finding of a rule.</summary>
    /// <returns>Whether it is listed.</returns>
    private bool IsListed(DiagnosticRule rule) => ++CollectionsMarshal.GetValueRefOrAddDefault(_counts, rule, out _) <= ShownPerRule;

    private string? HandleOf(int entity) => drawing?.SourceOf(entity).Handle;
}
