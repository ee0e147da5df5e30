namespace Engraver.Core.Machines.Origins;

/// <summary>The edge of a work piece that the tool touches from outside.</summary>
public enum WorkEdge
{
    /// <summary>The tool stands at smaller X than the work piece.</summary>
    Left,

    /// <summary>The tool stands at smaller Y.</summary>
    Bottom,

    /// <summary>The tool stands at larger X.</summary>
    Right,

    /// <summary>The tool stands at larger Y.</summary>
    Top,
}

/// <summary>Where the zero of the drawing lies when the tool touches the work piece.</summary>
public static class EdgeTouch
{
    /// <summary>The zero lies on the edge, which is the tool's radius away from its middle.</summary>
    /// <param name="at">The middle of the tool, controller counts.</param>
    /// <param name="radiusMm">Of the tool, or of the pin that stands in for it.</param>
    /// <returns>The place in the one axis that the edge tells; null in the other.</returns>
    public static (long? X, long? Y) ZeroAt(CountsPoint at, WorkEdge edge, double radiusMm, CountsScale scale)
    {
        var inward = edge is WorkEdge.Left or WorkEdge.Bottom ? radiusMm : -radiusMm;
        return edge is WorkEdge.Left or WorkEdge.Right
            ? (Counts(at.X + (inward * scale.X)), null)
            : (null, Counts(at.Y + (inward * scale.Y)));
    }

    /// <summary>The zero lies half-way between two touches from opposite sides; the tool's radius does not matter then.</summary>
    public static CountsPoint Middle(CountsPoint first, CountsPoint second) =>
        new(Counts(((double)first.X + second.X) / 2.0), Counts(((double)first.Y + second.Y) / 2.0));

    /// <summary>To the nearest count, half away from zero as everywhere.</summary>
    private static long Counts(double value) => checked((long)Math.Round(value, MidpointRounding.AwayFromZero));
}
