namespace Engraver.Core.Operations;

/// <summary>What an operation takes, by index.</summary>
internal sealed class TakenContent
{
    /// <summary>Rows of the analysed table.</summary>
    public List<int> Rows { get; } = [];

    /// <summary>Those of <see cref="Rows"/> that come from blocks at whose insertion points the operation drills.</summary>
    public HashSet<int> RowsOfBlocks { get; } = [];

    /// <summary>Rows of the table of areas.</summary>
    public List<int> Areas { get; } = [];

    /// <summary>Points at which it drills.</summary>
    public List<int> Points { get; } = [];

    /// <summary>Points of blocks at whose insertion points it drills.</summary>
    public List<int> PointsOfBlocks { get; } = [];

    /// <summary>Inserts at which it drills.</summary>
    public List<int> Inserts { get; } = [];

    public bool IsEmpty => Rows.Count + Areas.Count + Points.Count + PointsOfBlocks.Count + Inserts.Count == 0;

    /// <summary>Number of curves and places that both take.</summary>
    public int SharedWith(TakenContent other) => Rows.Intersect(other.Rows).Count() + Areas.Intersect(other.Areas).Count() + Points.Intersect(other.Points).Count() + Inserts.Intersect(other.Inserts).Count();
}
