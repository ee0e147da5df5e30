using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>One straight stretch of a zigzag between two walls.</summary>
/// <param name="Row">Number of its row, from the right of the rows' direction.</param>
/// <param name="Piece">The line in the direction of the rows.</param>
internal readonly record struct ZigzagRow(int Row, PathPiece Piece);

/// <summary>Parallel rows across a region, which together with the pass along the walls leave no material.</summary>
/// <remarks>The material left by the wall pass is deeper than the radius inside it. The rows divide it evenly, at most the stepover apart; each of its points
/// is within half a stepover of a row, and where it is nearest to the row the row is deeper than the radius less half a stepover. The rows can therefore end at
/// a slightly smaller depth, where the wall pass has cut.</remarks>
internal sealed class ZigzagRows
{
    /// <summary>Shortest row, millimetres.</summary>
    private const double Shortest = 1e-6;

    private readonly Vector2D _along;
    private readonly Vector2D _across;

    private ZigzagRows(Angle angle)
    {
        _along = new Vector2D(angle.Cos(), angle.Sin());
        _across = new Vector2D(-_along.Y, _along.X);
    }

    public List<ZigzagRow> Rows { get; } = [];

    /// <summary>The loops at which the rows end.</summary>
    public required IReadOnlyList<PassChain> Ends { get; init; }

    public static ZigzagRows Of(RegionDepths depths, PocketOptions options)
    {
        var wall = options.ToolRadius + options.Allowance;
        var inset = 0.9 * (options.ToolRadius - (options.PassDistance / 2.0));
        List<PassChain> ends = [.. depths.At(wall + inset).Select(loop => new PassChain(loop, true, PassKind.Row, 0))];
        var rows = new ZigzagRows(options.Angle) { Ends = ends };
        var left = depths.At(wall + options.ToolRadius).SelectMany(loop => loop).SelectMany(rows.ExtentOf).ToList();
        if (left.Count == 0) return rows;
        var (low, high) = (left.Min(), left.Max());
        var count = Math.Max(1, (int)Math.Ceiling((high - low) / options.PassDistance * (1.0 - 1e-12)));
        List<PathPiece> monotone = [.. ends.SelectMany(loop => loop.Pieces).SelectMany(rows.Monotone)];
        rows.Sweep(monotone, low, (high - low) / count, count);
        return rows;
    }

    /// <summary>Rows at a fixed distance across an area, without regard to what they clear. The rows of neighbouring areas continue each other.</summary>
    /// <param name="loops">The boundary of the area: closed loops, inside of an odd number of them.</param>
    /// <param name="spacing">Distance of the rows, mm.</param>
    public static IReadOnlyList<ZigzagRow> Across(IReadOnlyList<PathPiece> loops, Angle angle, double spacing)
    {
        var rows = new ZigzagRows(angle) { Ends = [] };
        var extent = loops.SelectMany(rows.ExtentOf).ToList();
        if (extent.Count == 0) return rows.Rows;
        var low = Math.Floor(extent.Min() / spacing) * spacing;
        rows.Sweep([.. loops.SelectMany(rows.Monotone)], low, spacing, (int)Math.Ceiling((extent.Max() - low) / spacing));
        return rows.Rows;
    }

    /// <summary>Smallest and largest coordinate across the rows.</summary>
    private IEnumerable<double> ExtentOf(PathPiece piece) => Monotone(piece).SelectMany(part => (double[])[Across(part.Start), Across(part.End)]);

    private double Across(Point2D place) => _across.Dot(place - Point2D.Origin);

    /// <summary>An arc cut where it runs along the rows, so that a row crosses each part at most once.</summary>
    private IEnumerable<PathPiece> Monotone(PathPiece piece)
    {
        if (!piece.IsArc) return [piece];
        List<double> cuts = [0.0, 1.0];
        foreach (var spoke in (Vector2D[])[_across, -_across])
        {
            var fraction = piece.AngleAhead(spoke) / Math.Abs(piece.Sweep);
            if (fraction is > 0.0 and < 1.0) cuts.Add(fraction);
        }

        cuts.Sort();
        return Enumerable.Range(0, cuts.Count - 1).Select(i => piece.Part(cuts[i], cuts[i] == 0.0 ? piece.Start : piece.At(cuts[i]), cuts[i + 1], cuts[i + 1] == 1.0 ? piece.End : piece.At(cuts[i + 1])));
    }

    /// <summary>All rows in one sweep from low to high, each with the pieces that extend over it.</summary>
    private void Sweep(List<PathPiece> pieces, double low, double step, int count)
    {
        var crossings = new List<double>[count];
        for (var row = 0; row < count; row++) crossings[row] = [];
        foreach (var piece in pieces)
        {
            var (start, end) = (Across(piece.Start), Across(piece.End));
            var first = Math.Max(0, (int)Math.Floor(((Math.Min(start, end) - low) / step) - 0.5));
            for (var row = first; row < count && HeightOf(row) <= Math.Max(start, end); row++)
            {
                if (start > HeightOf(row) != end > HeightOf(row)) crossings[row].Add(Crossing(piece, HeightOf(row), start, end));
            }
        }

        for (var row = 0; row < count; row++) AddRow(row, HeightOf(row), crossings[row]);

        double HeightOf(int row) => low + ((row + 0.5) * step);
    }

    private double Crossing(in PathPiece piece, double height, double start, double end)
    {
        if (!piece.IsArc)
        {
            var fraction = (height - start) / (end - start);
            return _along.Dot(piece.Start - Point2D.Origin + ((piece.End - piece.Start) * fraction));
        }

        var (centre, off) = (piece.Centre - Point2D.Origin, height - Across(piece.Centre));
        var half = Math.Sqrt(Math.Max(0.0, (piece.Radius - off) * (piece.Radius + off)));
        return _along.Dot(centre) + (_along.Dot(piece.At(0.5) - piece.Centre) >= 0.0 ? half : -half);
    }

    private void AddRow(int row, double height, List<double> crossings)
    {
        crossings.Sort();
        for (var i = 0; i + 1 < crossings.Count; i += 2)
        {
            if (crossings[i + 1] - crossings[i] > Shortest) Rows.Add(new ZigzagRow(row, PathPiece.Line(Place(crossings[i], height), Place(crossings[i + 1], height))));
        }
    }

    private Point2D Place(double along, double across) => Point2D.Origin + (_along * along) + (_across * across);
}
