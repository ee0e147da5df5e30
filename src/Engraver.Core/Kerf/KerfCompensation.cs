using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Kerf;

/// <summary>The stage between the drawing and the path of the tool's centre: contours at the distance of its radius, as lines and arcs.</summary>
public static class KerfCompensation
{
    /// <summary>Maximum number of findings with one place each; more are summarized.</summary>
    private const int MaxPlaces = 20;

    /// <param name="chained">The drawing, chained to contours.</param>
    /// <param name="options">Side and tool.</param>
    public static KerfResult Compensate(ChainedTable chained, KerfOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(options.ToolDiameterMm);
        var work = new CompensatedTableBuilder(chained, options);
        foreach (var group in Groups(work.Contours, options.Side)) work.Add(group);
        var open = options.Side is KerfSide.Left or KerfSide.Right ? 0 : work.KeepOpen();
        IReadOnlyList<UncutPlace> uncut = [.. work.Uncut.OrderByDescending(place => place.Uncut)];
        return new KerfResult(work.Table, uncut, open > 0, [.. work.Faults, .. Findings(uncut, open, options, chained.Drawing)]);
    }

    /// <summary>Contours that are offset together, by their indices.</summary>
    private static IEnumerable<int[]> Groups(IReadOnlyList<OffsetContour> contours, KerfSide side)
    {
        var numbers = Enumerable.Range(0, contours.Count).Where(number => contours[number].Closed || side is KerfSide.Left or KerfSide.Right).ToArray();
        return side == KerfSide.Nesting ? numbers.Length == 0 ? [] : [numbers] : numbers.Select(number => (int[])[number]);
    }

    private static IEnumerable<Diagnostic> Findings(IReadOnlyList<UncutPlace> uncut, int open, KerfOptions options, Drawing? drawing)
    {
        foreach (var place in uncut.Take(MaxPlaces)) yield return (place.IsWhole ? KerfRules.TooNarrow : KerfRules.CornerUncut).At(SourceOf(drawing, place.Entity), FactText.Of(place.Place.X), FactText.Of(place.Place.Y), FactText.Of(place.IsWhole ? options.ToolDiameterMm : place.Uncut));
        if (uncut.Count > MaxPlaces) yield return KerfRules.MoreUncut.At(default, FactText.Of(uncut.Count - MaxPlaces), FactText.Of(uncut[MaxPlaces].Uncut));
        if (open > 0) yield return KerfRules.OpenOnLine.At(default, FactText.Of(open));
    }

    internal static SourceRef SourceOf(Drawing? drawing, int entity) => drawing?.SourceOf(entity) ?? default;
}

/// <summary>The compensated table while it is built.</summary>
internal sealed class CompensatedTableBuilder(ChainedTable chained, KerfOptions options)
{
    public IReadOnlyList<OffsetContour> Contours { get; } = DrawnContours.From(chained);

    public EntityTable Table { get; } = new();

    public List<UncutPlace> Uncut { get; } = [];

    public List<Diagnostic> Faults { get; } = [];

    /// <summary>Compensates contours together.</summary>
    public void Add(int[] group)
    {
        if (options.CutsHeights && !IsLevel(group))
        {
            Fault(KerfRules.NotLevel, group[0], Contours[group[0]].Segments[0].Start);
            return;
        }

        IReadOnlyList<OffsetContour> drawn = [.. group.Select(number => Contours[number])];
        var side = options.Side switch { KerfSide.Inside => OffsetSide.In, KerfSide.Left => OffsetSide.Left, KerfSide.Right => OffsetSide.Right, _ => OffsetSide.Out };
        var offset = ContourOffset.Offset(drawn, options.Radius, side, OffsetOptions.Round(options.MaxErrorMm));
        foreach (var place in offset.Unresolved) Fault(KerfRules.NotCompensated, group[0], place);
        foreach (var loop in offset.Loops.OrderBy(loop => loop.Sources.Min(source => RowOf(group[source.Contour], source.Segment)))) Append(loop, group);
        var check = new KerfCheck(drawn, offset.Loops, options);
        if (check.MaxDeviation() is { } off) Fault(KerfRules.WrongDistance, group[off.Contour], off.Place, FactText.Of(off.Distance));
        for (var i = 0; i < group.Length; i++) Uncut.AddRange(check.UncutOf(i, segment => EntityOf(group[i], segment)));
    }

    /// <summary>Copies the contours that have no inside.</summary>
    /// <returns>Number of contours.</returns>
    public int KeepOpen()
    {
        var open = Enumerable.Range(0, Contours.Count).Where(number => !Contours[number].Closed).ToList();
        foreach (var piece in open.SelectMany(number => chained.Chain.Contours[number].Pieces.ToArray())) Table.Append(chained.Kept.CopySlots(piece.Row), chained.Kept.EntityIndexOf(piece.Row), chained.Kept.CurveOf(piece.Row));
        return open.Count;
    }

    private void Append(OffsetLoop loop, int[] group)
    {
        for (var i = 0; i < loop.Segments.Count; i++)
        {
            var row = RowOf(group[loop.Sources[i].Contour], loop.Sources[i].Segment);
            Table.Append(EntitySlots.Of(loop.Segments[i], chained.Kept[row][EntitySlot.StartZ]), chained.Kept.EntityIndexOf(row), null);
        }
    }

    private bool IsLevel(int[] group)
    {
        var heights = group.SelectMany(number => chained.Chain.Contours[number].Pieces.ToArray()).SelectMany(piece => (double[])[chained.Kept[piece.Row][EntitySlot.StartZ], chained.Kept[piece.Row][EntitySlot.EndZ]]).ToList();
        return heights.Max() - heights.Min() <= EndHeights.ToleranceFor(options.JoinToleranceMm);
    }

    private int RowOf(int contour, int segment) => chained.Chain.Contours[contour].Pieces.Span[segment].Row;

    private int EntityOf(int contour, int segment) => chained.Kept.EntityIndexOf(RowOf(contour, segment));

    private void Fault(DiagnosticRule rule, int contour, Point2D place, params string[] facts) =>
        Faults.Add(rule.At(KerfCompensation.SourceOf(chained.Drawing, EntityOf(contour, 0)), [FactText.Of(place.X), FactText.Of(place.Y), .. facts]));
}
