using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Sequencing.Ordering;

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
