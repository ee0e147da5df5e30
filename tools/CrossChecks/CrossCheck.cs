using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Tools.CrossChecks;

/// <summary>A second reading of a DXF file by the simplest possible code, to be compared with that of the reader: number of curves by type, total length,
/// box. It shares no code with the reader.</summary>
/// <param name="Counts">Curves after block expansion by the type they were written as.</param>
/// <param name="Length">Along the curves in space, drawing units.</param>
/// <param name="Bounds">In plan; null when there is no curve with an extent.</param>
public sealed record CrossCheck(IReadOnlyDictionary<string, int> Counts, double Length, Bounds2D? Bounds)
{
    private const double Tolerance = 1e-6;

    /// <summary>Where records may have been lost, so that the figures are unreliable; null if there is no such place.</summary>
    public string? Damage { get; private init; }

    /// <exception cref="CrossCheckException">The drawing is too large, or a block contains itself.</exception>
    public static CrossCheck Read(byte[] file)
    {
        var tally = CrossCheckReading.Read(file);
        var bounds = tally.X.Min <= tally.X.Max && tally.Y.Min <= tally.Y.Max ? Bounds2D.FromCorners(new Point2D(tally.X.Min, tally.Y.Min), new Point2D(tally.X.Max, tally.Y.Max)) : (Bounds2D?)null;
        return new CrossCheck(tally.Counts, tally.Length, bounds) { Damage = CrossCheckDamage.In(new CrossCheckFile(file)) };
    }

    /// <summary>A sentence for each figure in which the two readings differ, and one for damage; empty if they agree.</summary>
    public IReadOnlyList<string> DifferencesFrom(DrawingSummary first)
    {
        var differences = new List<string>();
        var counted = first.Leaf.ToDictionary(pair => pair.Key.ToDxfName(), pair => pair.Value, StringComparer.Ordinal);
        foreach (var type in counted.Keys.Union(Counts.Keys).Order(StringComparer.Ordinal))
        {
            var (one, two) = (counted.GetValueOrDefault(type), Counts.GetValueOrDefault(type));
            if (one != two) differences.Add(Wording.Get("CrossCheck.CurvesDiffer", type, one, two));
        }

        if (!Near(first.Length.Total, Length, Math.Max(1.0, Length))) differences.Add(Wording.Get("CrossCheck.LengthDiffers", first.Length.Total, Length));
        if (!Agree(first.Bounds, Bounds)) differences.Add(Wording.Get("CrossCheck.ExtentsDiffer", Named(first.Bounds), Named(Bounds)));
        if (Damage is not null) differences.Add(Damage);
        return differences;
    }

    private static bool Agree(Bounds2D? one, Bounds2D? two)
    {
        if (one is not { } a || two is not { } b) return one is null && two is null;
        var size = new[] { 1.0, Math.Abs(b.MinX), Math.Abs(b.MinY), Math.Abs(b.MaxX), Math.Abs(b.MaxY) }.Max();
        return Near(a.MinX, b.MinX, size) && Near(a.MinY, b.MinY, size) && Near(a.MaxX, b.MaxX, size) && Near(a.MaxY, b.MaxY, size);
    }

    private static bool Near(double one, double two, double size) => Math.Abs(one - two) <= Tolerance * size;

    private static string Named(Bounds2D? bounds) => bounds is { } box ? Wording.Get("CrossCheck.Extents", box.MinX, box.MinY, box.MaxX, box.MaxY) : Wording.Get("CrossCheck.NoExtents");
}
