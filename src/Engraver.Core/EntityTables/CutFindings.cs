using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.EntityTables;

/// <summary>Findings about a drawing before it is cut: visible content that is not cut, heights that a flat machine does not have, a size or position that
/// exceeds every machine.</summary>
public static class CutFindings
{
    /// <summary>Largest size in either direction, mm; about that of the largest flat-bed machines on the market. A profile does not yet contain the size of its
    /// machine's table.</summary>
    public const double LargestMm = 10_000.0;

    /// <summary>Largest distance from the tool's start, mm: the diagonal of the largest machine, with some room.</summary>
    public const double FarthestMm = 20_000.0;

    /// <param name="selection">The layers that are cut.</param>
    /// <param name="toolStart">The drawing point at which the tool is, mm.</param>
    /// <param name="joinTolerance">As for sequencing; heights that differ by less are equal.</param>
    /// <param name="cutsHeights">An axis moves the tool, so heights are cut and are not reported.</param>
    public static IReadOnlyList<Diagnostic> Find(Drawing drawing, LayerSelection selection, Point2D toolStart, double joinTolerance, bool cutsHeights = false)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var findings = new List<Diagnostic>();
        if (NotCutFindings.From(drawing, selection).Finding is { } notCut) findings.Add(notCut);
        var extent = CutExtent.From(drawing, selection, EndHeights.ToleranceFor(joinTolerance));
        if (!cutsHeights && !extent.Bounds.IsEmpty) AddHeights(findings, drawing, extent);
        if (!extent.Bounds.IsEmpty) AddSize(findings, drawing, extent.Bounds, toolStart);
        return findings;
    }

    private static void AddHeights(List<Diagnostic> findings, Drawing drawing, CutExtent extent)
    {
        if (extent.Slanted is { Count: > 0 } slanted) findings.Add(PreparationRules.NotLevel.At(drawing.SourceOf(slanted.First), NumberText.Whole(slanted.Count), FactText.Of(slanted.Low, 3), FactText.Of(slanted.High, 3)));
        if (extent.Levels > 1) findings.Add(PreparationRules.SeveralHeights.At(default, NumberText.Whole(extent.Levels), FactText.Of(extent.Low, 3), FactText.Of(extent.High, 3)));
        else if (Math.Abs(extent.Low) > extent.Tolerance && extent.Slanted.Count == 0) findings.Add(PreparationRules.OneHeight.At(default, FactText.Of(extent.Low, 3)));
    }

    private static void AddSize(List<Diagnostic> findings, Drawing drawing, Bounds2D bounds, Point2D toolStart)
    {
        var (dx, dy) = (Math.Max(Math.Abs(bounds.MinX - toolStart.X), Math.Abs(bounds.MaxX - toolStart.X)), Math.Max(Math.Abs(bounds.MinY - toolStart.Y), Math.Abs(bounds.MaxY - toolStart.Y)));
        var distance = double.Hypot(dx, dy);
        if (bounds.Width <= LargestMm && bounds.Height <= LargestMm && distance <= FarthestMm) return;
        findings.Add(PreparationRules.TooLarge.At(default, FactText.Of(bounds.Width, 3), FactText.Of(bounds.Height, 3), FactText.Of(distance, 3), FactText.Of(LargestMm, 3), FactText.Of(FarthestMm, 3), Guess(drawing, bounds)));
    }

    /// <summary>The probable cause of such numbers in a drawing.</summary>
    private static string Guess(Drawing drawing, Bounds2D bounds)
    {
        var (unit, scale) = (drawing.Unit, drawing.Scale);
        var size = Math.Max(bounds.Width, bounds.Height);
        if (size <= LargestMm) return Wording.Get("CutFindings.FarFromOrigin");
        var asNumbers = scale.ToDrawing(size);
        var isStated = unit.Source == "INSUNITS";
        return asNumbers <= LargestMm && unit.MillimetresPerUnit > 1.0
            ? Wording.Get(isStated ? "CutFindings.StatedUnitTooLarge" : "CutFindings.AssumedUnitTooLarge", unit.Name, FactText.Of(scale.ToDrawing(bounds.Width), 3), FactText.Of(scale.ToDrawing(bounds.Height), 3))
            : Wording.Get(isStated ? "CutFindings.StatedUnitBuilding" : "CutFindings.AssumedUnitBuilding", unit.Name);
    }
}
