using Engraver.Core.Geometry;

namespace Engraver.Workbench.Settings;

/// <summary>The entering entity (paper 000, ENTER): named by its handle or by a drawing point, mm.</summary>
public abstract record ContourEntry
{
    private ContourEntry()
    {
    }

    /// <param name="Handle">Hexadecimal DXF handle, case does not matter.</param>
    public sealed record ByHandle(string Handle) : ContourEntry;

    public sealed record ByPoint(Point2D Point) : ContourEntry;
}
