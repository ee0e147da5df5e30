using Engraver.Core.Geometry;

namespace Engraver.Core.Plots;

/// <summary>Keeps numbers and arrows from overlapping: an area is used only once, and a label without a free area is left out.</summary>
internal sealed class LabelField(double cell)
{
    private readonly HashSet<(int X, int Y)> _given = [];

    /// <summary>Reserves a box of picture units; false when part of it is already taken.</summary>
    public bool TryReserve(Point2D corner, double width, double height)
    {
        var cells = Cells(corner, width, height).ToList();
        if (cells.Exists(_given.Contains)) return false;
        _given.UnionWith(cells);
        return true;
    }

    private IEnumerable<(int X, int Y)> Cells(Point2D corner, double width, double height)
    {
        for (var x = (int)Math.Floor(corner.X / cell); x <= (int)Math.Floor((corner.X + width) / cell); x++)
        {
            for (var y = (int)Math.Floor(corner.Y / cell); y <= (int)Math.Floor((corner.Y + height) / cell); y++) yield return (x, y);
        }
    }
}
