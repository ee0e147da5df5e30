using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Sequencing.ArcRecovery;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Nesting;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Core.Sequencing;

/// <summary>Converts an analysed table to strokes in the order of cutting. In two steps, so that a caller can time or repeat the second step alone.</summary>
public static class Sequencer
{
    /// <summary>Chaining and ordering in one step.</summary>
    /// <param name="analysed">The result of <see cref="ArcAnalysis.Analyse"/>.</param>
    /// <param name="drawing">The drawing of the entity indices, for handles and for the parts of ellipses and splines. Null when there is none.</param>
    /// <param name="options">Tolerances and requests.</param>
    public static SequencingResult Sequence(EntityTable analysed, Drawing? drawing, SequencingOptions options) =>
        Order(Chain(analysed, drawing, options), options);

    /// <summary>Removes duplicates, recovers arcs if requested, joins contours and determines their nesting.</summary>
    public static ChainedTable Chain(EntityTable analysed, Drawing? drawing, SequencingOptions options)
    {
        var segments = analysed.ToSegments();
        var kept = analysed;
        var findings = new SequencingFindings(drawing, options);
        var ends = default(SegmentEnds); // of the final segments
        if (!options.KeepDuplicates)
        {
            ends = new SegmentEnds(segments, options.JoinTolerance);
            var heights = options.CutsHeights ? EndHeights.From(analysed, options.JoinTolerance) : EndHeights.Flat;
            var rows = ends.MayCoincide(segments, options.DuplicateTolerance) is { } candidates
                ? DuplicateRemoval.Keep(segments, options.DuplicateTolerance, heights, candidates)
                : DuplicateRemoval.Keep(segments, options.DuplicateTolerance, heights);
            if (rows.Length < segments.Length)
            {
                findings.AddDuplicates(analysed, rows);
                kept = analysed.Picking(rows);
                (segments, ends) = (kept.ToSegments(), null);
            }
        }

        var duplicates = analysed.Count - kept.Count;
        var areLevel = !options.CutsHeights || EndHeights.From(kept, options.JoinTolerance).AreFlat;
        if (options.ArcTolerance is { } arcTolerance && areLevel && ArcRecoverer.Recover(kept, segments, arcTolerance) is { Arcs.Count: > 0 } recovered)
        {
            findings.AddArcs(recovered);
            kept = recovered.Table;
            (segments, ends) = (kept.ToSegments(), null);
        }

        var chain = ContourChainer.Chain(segments, ends ?? new SegmentEnds(segments, options.JoinTolerance), options.JoinTolerance, EndHeights.From(kept, options.JoinTolerance), LettersOf(kept, drawing));
        var inside = ContourNesting.Find(chain.Contours, segments, options.JoinTolerance);
        findings.AddChain(chain, kept, segments);
        findings.SumUp();
        return new ChainedTable(analysed, kept, segments, chain, inside, drawing, findings.Diagnostics) { DuplicatesRemoved = duplicates };
    }

    /// <summary>Puts the contours in order, reverses and rotates them, and writes the sequenced table.</summary>
    public static SequencingResult Order(ChainedTable chained, SequencingOptions options)
    {
        var findings = new SequencingFindings(chained.Drawing, options, chained.Diagnostics);
        var entries = Entries(chained, options, findings);
        var (table, reversed) = SequencedTable.Write(chained, entries);
        var strokes = Strokes(chained, entries, table);
        var travel = TravelDistance.Through(options.ToolStart, strokes);
        return new SequencingResult
        {
            Strokes = strokes,
            Discontinuities = new OpenEndList(chained, options),
            Table = table,
            Segments = strokes.Sum(stroke => stroke.Segments),
            Reversed = reversed,
            DuplicatesRemoved = chained.DuplicatesRemoved,
            PathLength = strokes.Sum(stroke => stroke.Length),
            Travel = travel,
            TravelAndBack = travel + (strokes.Count == 0 ? 0.0 : strokes[^1].End.DistanceTo(options.ToolStart)),
            TravelAsDrawn = TravelDistance.AsDrawn(options.ToolStart, chained.Analysed),
            Diagnostics = findings.Diagnostics,
        };
    }

    private static Predicate<int>? LettersOf(EntityTable table, Drawing? drawing) => drawing is null ? null : row => drawing.Entities[table.EntityIndexOf(row)].Type.IsLetters();

    private static IReadOnlyList<StrokeEntry> Entries(ChainedTable chained, SequencingOptions options, SequencingFindings findings)
    {
        var contours = chained.Chain.Contours;
        var segments = chained.Segments.Span;
        int[] inside = [.. chained.Inside];
        var depth = options.CutsHeights ? DepthOrder.From(contours, segments, EndHeights.From(chained.Kept, options.JoinTolerance), options.DuplicateTolerance, EndHeights.ToleranceFor(options.JoinTolerance)) : DepthOrder.None;
        depth.Untangle(inside);
        var first = default(StrokeEntry?);
        if (options.Entry is { } requested)
        {
            var enter = EntrySubstitute.Resolve(requested, chained);
            first = EntrySearch.Find(enter, chained, options.ToolStart);
            findings.AddEntry(requested, enter, first, inside);
        }

        if (options.Order == StrokeOrder.Drawn) return TravelOrder.Drawn(contours, segments, inside, options.ToolStart, first);
        var nearest = TravelOrder.Nearest(contours, chained.Segments, inside, depth, options.ToolStart, first);
        if (options.Order == StrokeOrder.Nearest) return nearest;
        var optimal = new OptimalOrder(contours, chained.Segments, inside, depth, options.Search);
        return optimal.Of(nearest, first?.Contour, options.ToolStart, options.ToolEnd);
    }

    private static StrokeList Strokes(ChainedTable chained, IReadOnlyList<StrokeEntry> entries, EntityTable table)
    {
        var place = new int[entries.Count];
        for (var i = 0; i < place.Length; i++) place[entries[i].Contour] = i;
        var curves = new CurveCount(chained.Drawing);
        var strokes = new StrokeList(table, entries.Count);
        foreach (var entry in entries)
        {
            var contour = chained.Chain.Contours[entry.Contour];
            var outer = chained.Inside[entry.Contour];
            strokes.Add(contour.Closed, contour.Pieces.Length, outer < 0 ? -1 : place[outer], curves);
        }

        return strokes;
    }
}
