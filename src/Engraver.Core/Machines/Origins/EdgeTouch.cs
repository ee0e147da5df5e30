namespace Engraver.Core.Machines.Origins;

/// <summary>Computes the drawing's zero from a tool that touches the work piece.</summary>
public static class EdgeTouch
{
    /// <summary>The zero is on the edge, which is one tool radius away from the tool's centre.</summary>
    /// <param name="at">The centre of the tool, controller counts.</param>
    /// <param name="radiusMm">Radius of the tool, or of the pin used in its place.</param>
    /// <returns>The position in the axis that the edge determines; null in the other.</returns>
    public static (long? X, long? Y) ZeroAt(CountsPoint at, WorkEdge edge, double radiusMm, CountsScale scale)
    {
        var inward = edge is WorkEdge.Left or WorkEdge.Bottom ? radiusMm : -radiusMm;
        return edge is WorkEdge.Left or WorkEdge.Right
            ? (Counts(at.X + scale.X.Exact(inward)), null)
            : (null, Counts(at.Y + scale.Y.Exact(inward)));
    }

    /// <summary>The zero is half-way between two touches from opposite sides; the tool's radius then does not matter.</summary>
    public static CountsPoint Middle(CountsPoint first, CountsPoint second) =>
        new(Counts(((double)first.X + second.X) / 2.0), Counts(((double)first.Y + second.Y) / 2.0));

    /// <summary>Rounds to the nearest count, half away from zero.</summary>
    private static long Counts(double value) => checked((long)Math.Round(value, MidpointRounding.AwayFromZero));
}
