using Avalonia;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>Builds the outline of a figure at half the line's width: along its left side, and back along the other.</summary>
internal sealed class StrokeOutline(VectorPath outline, StrokeStyle style, double scale)
{
    private const double StraightOn = 0.99999;

    /// <summary>Largest distance of a round join's or cap's chords from the circle, in device pixels.</summary>
    private const double ArcTolerance = 0.03;

    private readonly double _half = style.Width / 2;
    private readonly double _arcStep = 2 * Math.Acos(Math.Max(0.5, 1 - ArcTolerance / Math.Max(ArcTolerance * 2, style.Width / 2 * scale)));
    private bool _hasStarted;

    public void Draw(Polyline figure)
    {
        var points = figure.Points;
        _hasStarted = false;
        if (points.Count == 1)
            DrawPoint(points[0]);
        else if (figure.IsClosed && points.Count > 2)
            DrawRing(points);
        else
            DrawOpen(points, figure.IsClosed);
    }

    private void DrawPoint(Vector point)
    {
        var box = new Rect(point.X - _half, point.Y - _half, style.Width, style.Width);
        if (style.Cap == PenLineCap.Round)
            outline.AddEllipse(box);
        else if (style.Cap == PenLineCap.Square)
            outline.AddRectangle(box);
    }

    private void DrawRing(List<Vector> points)
    {
        var count = points.Count;
        for (var i = 0; i < count; i++)
            AddJoin(points[(i + count - 1) % count], points[i], points[(i + 1) % count]);
        outline.Close();
        _hasStarted = false;
        for (var i = count - 1; i >= 0; i--)
            AddJoin(points[(i + 1) % count], points[i], points[(i + count - 1) % count]);
        outline.Close();
    }

    /// <summary>Draws an open figure; a closed figure of two points is drawn the same way, with joins instead of caps.</summary>
    private void DrawOpen(List<Vector> points, bool isClosed)
    {
        var last = points.Count - 1;
        for (var i = 1; i < last; i++)
            AddJoin(points[i - 1], points[i], points[i + 1]);
        AddEnd(points[last - 1], points[last], isClosed);
        for (var i = last - 1; i > 0; i--)
            AddJoin(points[i + 1], points[i], points[i - 1]);
        AddEnd(points[1], points[0], isClosed);
        outline.Close();
    }

    private void AddEnd(Vector before, Vector end, bool isClosed)
    {
        if (isClosed)
            AddJoin(before, end, before);
        else
            AddCap(before, end);
    }

    private void AddCap(Vector before, Vector end)
    {
        var normal = Normal(before, end);
        var ahead = new Vector(-normal.Y, normal.X);
        switch (style.Cap)
        {
            case PenLineCap.Square:
                Add(end + normal + ahead);
                Add(end - normal + ahead);
                break;
            case PenLineCap.Round:
                AddArc(end, normal, Math.PI);
                break;
            default:
                Add(end + normal);
                Add(end - normal);
                break;
        }
    }

    private void AddJoin(Vector before, Vector corner, Vector after)
    {
        Vector normal0 = Normal(before, corner), normal1 = Normal(corner, after);
        var cosine = Vector.Dot(normal0, normal1) / (_half * _half);
        var turn = Vector.Cross(normal0, normal1);
        if (cosine > StraightOn)
        {
            Add(corner + normal1);
        }
        else if (turn < 0)
        {
            AddInnerJoin(before, corner, after, normal0, normal1, cosine);
        }
        else
        {
            AddOuterJoin(corner, normal0, normal1, cosine);
        }
    }

    /// <summary>Adds the crossing of both borders; where a segment is too short for that, a point through the corner itself, so that there is no
    /// hole.</summary>
    private void AddInnerJoin(Vector before, Vector corner, Vector after, Vector normal0, Vector normal1, double cosine)
    {
        var back = _half * Math.Sqrt(Math.Max(0, 1 - cosine) / Math.Max(1e-9, 1 + cosine));
        if (back * back < Math.Min((corner - before).SquaredLength, (after - corner).SquaredLength))
        {
            Add(corner + (normal0 + normal1) / (1 + cosine));
            return;
        }
        Add(corner + normal0);
        Add(corner);
        Add(corner + normal1);
    }

    private void AddOuterJoin(Vector corner, Vector normal0, Vector normal1, double cosine)
    {
        if (style.Join == PenLineJoin.Round)
        {
            AddArc(corner, normal0, Math.Acos(Math.Clamp(cosine, -1, 1)));
            return;
        }
        var halfCosine = Math.Sqrt(Math.Max(0, (1 + cosine) / 2));
        if (style.Join == PenLineJoin.Miter && halfCosine * Math.Max(1, style.MiterLimit) >= 1)
        {
            var middle = normal0 + normal1;
            Add(corner + middle * (_half / halfCosine / middle.Length));
            return;
        }
        Add(corner + normal0);
        Add(corner + normal1);
    }

    private void AddArc(Vector centre, Vector from, double sweep)
    {
        var steps = Math.Max(1, (int)Math.Ceiling(sweep / _arcStep));
        var start = Math.Atan2(from.Y, from.X);
        for (var i = 0; i <= steps; i++)
        {
            var (sin, cos) = Math.SinCos(start + sweep * i / steps);
            Add(centre + new Vector(cos, sin) * _half);
        }
    }

    private void Add(Vector point)
    {
        if (_hasStarted)
            outline.LineTo(new Point(point.X, point.Y));
        else
            outline.MoveTo(new Point(point.X, point.Y));
        _hasStarted = true;
    }

    /// <summary>Vector of half the line's width, to the left of the direction on screen.</summary>
    private Vector Normal(Vector from, Vector to)
    {
        var along = to - from;
        var length = along.Length;
        return length > 0 ? new Vector(along.Y, -along.X) * (_half / length) : default;
    }
}
