using System.Text;
using Engraver.Core.Geometry;

namespace Engraver.Core.Plots;

/// <summary>Lines of one colour at a resolution, as the d attribute of an SVG path: a line that would ink no new cell of the picture is left out, as are
/// vertices nearer to each other than half a cell.</summary>
/// <remarks>Every omitted line is within one and a half cell diagonals of a drawn line, and every drawn line is within half a cell of the original.</remarks>
/// <param name="width">Width of the picture, in its units.</param>
/// <param name="height">Height of the picture, in its units.</param>
/// <param name="cell">The resolution, in its units.</param>
internal sealed class PlotInk(double width, double height, double cell)
{
    private readonly int _columns = (int)(width / cell) + 1;
    private readonly int _rows = (int)(height / cell) + 1;
    private readonly ulong[] _inked = new ulong[((((long)(width / cell) + 1) * ((long)(height / cell) + 1)) / 64) + 1];
    private readonly StringBuilder _path = new();
    private Point2D _kept;
    private Point2D? _pen;

    public int Length => _path.Length;

    /// <summary>The path so far.</summary>
    public override string ToString() => _path.ToString();

    /// <summary>Adds a curve through these points of the picture.</summary>
    public void Add(IEnumerable<Point2D> places)
    {
        Point2D? last = null;
        foreach (var place in places)
        {
            if (last is null) _kept = place;
            else if (place.DistanceTo(_kept) >= cell / 2.0) LineTo(place);
            last = place;
        }

        if (last is { } end && (end != _kept || _pen != _kept)) LineTo(end);
        _pen = null;
    }

    private void LineTo(Point2D place)
    {
        if (Ink(_kept, place))
        {
            if (_pen != _kept) Append('M', _kept);
            Append('L', place);
            _pen = place;
        }

        _kept = place;
    }

    /// <summary>A tenth of a unit is below every resolution.</summary>
    private void Append(char letter, Point2D place) => _path.Append(letter).Append(NumberText.Rounded(place.X, 1)).Append(',').Append(NumberText.Rounded(place.Y, 1));

    /// <summary>Inks the cells from one place to the other, in steps of at most one along the longer side.</summary>
    /// <returns>True when one of them was not inked before.</returns>
    private bool Ink(Point2D from, Point2D to)
    {
        var (x, y, dx, dy) = (from.X / cell, from.Y / cell, (to.X - from.X) / cell, (to.Y - from.Y) / cell);
        var (steps, isNew) = ((int)Math.Ceiling(Math.Max(Math.Abs(dx), Math.Abs(dy))), false);
        for (var i = 0; i <= steps; i++)
        {
            var part = steps == 0 ? 0.0 : (double)i / steps;
            var (column, row) = (Math.Clamp((int)(x + (dx * part)), 0, _columns - 1), Math.Clamp((int)(y + (dy * part)), 0, _rows - 1));
            var (index, bit) = Math.DivRem(((long)row * _columns) + column, 64);
            isNew |= (_inked[index] & (1UL << (int)bit)) == 0;
            _inked[index] |= 1UL << (int)bit;
        }

        return isNew;
    }
}
