using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>Checks whether the tool may move straight from one point to another without a lift.</summary>
internal sealed class LinkCheck
{
    /// <summary>Millimetres by which a link may be nearer to a wall than the radius: twice the amount by which a channel may be narrower.</summary>
    private const double Rounding = 1e-6;

    private readonly SweptReach _walls;
    private readonly PocketOptions _options;

    public LinkCheck(PocketRegion region, PocketOptions options)
    {
        _options = options;
        _walls = new SweptReach([.. region.Walls.SelectMany(wall => wall)], options.ToolRadius - Rounding);
    }

    /// <summary>Longest step from a pass to its neighbour.</summary>
    public double LongestStep => Math.Max(_options.PassDistance, _options.ToolRadius) * (1.0 + 1e-6);

    /// <summary>True when a tool that starts inside the region touches no wall on its path.</summary>
    public bool StaysInside(in PathPiece way) => way.Length == 0.0 || _walls.PartsOutside(way) is [var part] && part == PiecePart.Whole;

    /// <summary>Length of the part of a tool centre path that is farther than the radius from the cut area: there the full width is cut.</summary>
    public double Uncut(in PathPiece way, IReadOnlyList<PathPiece> cut) => Uncut(way, new SweptReach(cut, _options.ToolRadius * (1.0 + 1e-9)));

    public static double Uncut(PathPiece way, SweptReach cut) => cut.PartsOutside(way).Sum(part => (part.To - part.From) * way.Length);
}
