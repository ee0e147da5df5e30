using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.TestKit;

/// <summary>Builds a drawing by hand, one call per entity in file order; handles are A1, A2 ... and lines 10, 20 ...</summary>
public sealed class DrawingBuilder
{
    private readonly List<Layer> _layers = [new Layer("0", On: true, Frozen: false, Plot: true)];
    private readonly GrowingColumn<DrawingEntity> _entities = new();
    private readonly GrowingColumn<DrawingPart> _parts = new();
    private readonly List<RationalCurve> _curves = [];
    private int _layer;
    private bool _hidden;

    public LengthUnit Unit { get; init; } = LengthUnit.AssumedMillimetres;

    /// <summary>Sets the layer of the following entities.</summary>
    public DrawingBuilder OnLayer(Layer layer)
    {
        if (!_layers.Contains(layer)) _layers.Add(layer);
        _layer = _layers.IndexOf(layer);
        return this;
    }

    /// <summary>Makes the following entities invisible.</summary>
    public DrawingBuilder Hidden()
    {
        _hidden = true;
        return this;
    }

    public DrawingBuilder Line(double x1, double y1, double x2, double y2)
    {
        var entity = Add(CurveType.Line, 1, closed: false);
        _parts.Add(DrawingPart.Line(entity, x1, y1, 0.0, x2, y2, 0.0));
        return this;
    }

    /// <summary>Counter-clockwise from start to end angle, degrees, as DXF writes arcs.</summary>
    public DrawingBuilder Arc(double x, double y, double radius, double startDegrees, double endDegrees)
    {
        var sweep = (endDegrees - startDegrees) % 360.0;
        if (sweep < 0.0) sweep += 360.0;
        return Curve(CurveType.Arc, ArcOf(x, y, radius, startDegrees, sweep));
    }

    public DrawingBuilder Circle(double x, double y, double radius) => Curve(CurveType.Circle, ArcOf(x, y, radius, 0.0, 360.0));

    /// <summary>A curve of the given type, made of lines and arcs.</summary>
    public DrawingBuilder Curve(CurveType type, params Segment[] segments)
    {
        var entity = Add(type, segments.Length, segments[0].Start == segments[^1].End);
        foreach (var segment in segments)
        {
            _parts.Add(segment.Kind == SegmentKind.Line
                ? DrawingPart.Line(entity, segment.Start.X, segment.Start.Y, 0.0, segment.End.X, segment.End.Y, 0.0)
                : DrawingPart.Arc(entity, segment.Arc, 0.0));
        }

        return this;
    }

    /// <summary>An ellipse or spline as one curve.</summary>
    public DrawingBuilder Free(RationalCurve curve)
    {
        var entity = Add(curve.Kind == SegmentKind.Ellipse ? CurveType.Ellipse : CurveType.Spline, 1, curve.IsClosed);
        _curves.Add(curve);
        _parts.Add(DrawingPart.FreeCurve(entity, curve.Kind, _curves.Count - 1));
        return this;
    }

    /// <summary>A closed polyline through the corners of an axis-parallel square, counter-clockwise from the lower left.</summary>
    public DrawingBuilder Square(double x, double y, double side) => Curve(
        CurveType.LwPolyline,
        Segment.FromLine(new Point2D(x, y), new Point2D(x + side, y)),
        Segment.FromLine(new Point2D(x + side, y), new Point2D(x + side, y + side)),
        Segment.FromLine(new Point2D(x + side, y + side), new Point2D(x, y + side)),
        Segment.FromLine(new Point2D(x, y + side), new Point2D(x, y)));

    public Drawing Build()
    {
        var counts = new Dictionary<string, int>();
        var balance = new ReadBalance(counts, _entities.Count, 0, [], [], new Dictionary<string, int>(), 0);
        return new Drawing("by hand", 0, "AC1015", "ascii", Unit, _layers, _entities, _parts, balance, []) { Curves = _curves };
    }

    private static Segment ArcOf(double x, double y, double radius, double start, double sweep) =>
        Segment.FromArc(new ArcSegment(new Point2D(x, y), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep)));

    private int Add(CurveType type, int parts, bool closed) => _entities.Add(new DrawingEntity
    {
        Type = type,
        FirstPart = _parts.Count,
        PartCount = parts,
        Layer = _layer,
        Hidden = _hidden,
        Closed = closed,
        Handle = (ulong)(0xA1 + _entities.Count),
        SourceLine = 10 * (_entities.Count + 1),
    });
}
