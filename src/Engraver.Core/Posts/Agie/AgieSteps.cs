using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.Agie;

/// <summary>Collects blocks and tracks the machine position after the last one, in micrometres from the start of the first stroke.</summary>
internal sealed class AgieSteps(Point2D entry)
{
    /// <summary>Maximum number of blocks of a job; a tape with more blocks would be kilometres long.</summary>
    public const int MaxCount = 499_500;

    private readonly List<AgieStep> _steps = [];

    public IReadOnlyList<AgieStep> All => _steps;

    /// <summary>There were more than <see cref="MaxCount"/>.</summary>
    public bool TooMany { get; private set; }

    /// <summary>Predicted machine position: whole micrometres after lines, radius times cosine and sine after arcs.</summary>
    public Point2D Place { get; private set; }

    /// <summary>The stroke and move for which blocks are created.</summary>
    public (int Stroke, int Move) For { get; set; }

    /// <summary>A place of the drawing, millimetres, in micrometres from the entry.</summary>
    public Point2D Of(Point2D place) => new((place.X - entry.X) * 1000.0, (place.Y - entry.Y) * 1000.0);

    public void Add(AgieBlock block, Segment? drawn)
    {
        TooMany |= _steps.Count >= MaxCount;
        if (TooMany) return;
        _steps.Add(new AgieStep(block, drawn, For.Stroke, drawn is null ? -1 : For.Move));
        Place = block.PathFrom(Place).End;
    }

    /// <summary>Adds a straight move by whole micrometres, in equal parts when six digits cannot hold it; no block for zero length.</summary>
    /// <param name="way">Micrometres.</param>
    /// <param name="drawn">Null for positioning.</param>
    public void Line(Vector2D way, Segment? drawn)
    {
        var (x, y) = (Rounded(way.X), Rounded(way.Y));
        var parts = Math.Max(1.0, Math.Ceiling(Math.Max(Math.Abs(x), Math.Abs(y)) / AgieBlock.Largest));
        if (x == 0.0 && y == 0.0) return;
        if (parts > MaxCount) TooMany = true;
        for (var i = 0; i < parts && !TooMany; i++)
            Add(AgieBlock.Line((int)(Rounded(x * (i + 1) / parts) - Rounded(x * i / parts)), (int)(Rounded(y * (i + 1) / parts) - Rounded(y * i / parts)), cutting: drawn is not null), drawn);
    }

    public static double Rounded(double value) => Math.Round(value, MidpointRounding.AwayFromZero);
}
