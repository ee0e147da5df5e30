using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>The curve that a record draws, before it goes into the columns. Filled again for every record.</summary>
internal sealed class CurveShape
{
    /// <summary>Grows from nothing: a hatch may have a million loops, each a shape of its own.</summary>
    private DrawingPart[] _parts = [];
    private int _count;

    public CurveType Type { get; private set; }

    public bool Closed { get; set; }

    /// <summary>What is odd about the record though it was taken.</summary>
    public List<RecordIssue> Oddities { get; } = [];

    public ReadOnlySpan<DrawingPart> Parts => _parts.AsSpan(0, _count);

    /// <summary>The parts that are ellipses or splines refer to these.</summary>
    public List<RationalCurve> Curves { get; } = [];

    public Span<DrawingPart> MutableParts => _parts.AsSpan(0, _count);

    /// <summary>False when a factor (a ratio, a bulge, a weight) carried a value beyond what can be reckoned with, though every number was usable as written.</summary>
    public bool IsInRange
    {
        get
        {
            foreach (ref readonly var part in Parts)
            {
                if (part.IsFreeCurve ? !PlacedPart.InRange(Curves[part.CurveIndex]) : !PlacedPart.InRange(new Vector3D(part.A, part.B, part.D))) return false;
            }

            return true;
        }
    }

    /// <summary>The row for the column of entities; its parts are still to be placed.</summary>
    public DrawingEntity ToEntity(EntityRecord record) => new()
    {
        SourceLine = record.Line,
        Handle = record.Handle,
        Layer = record.Layer,
        Colour = record.Colour,
        Type = Type,
        Hidden = record.Invisible,
        Closed = Closed,
    };

    public void Begin(CurveType type)
    {
        Type = type;
        Closed = false;
        _count = 0;
        Curves.Clear();
        Oddities.Clear();
    }

    public void Add(in DrawingPart part)
    {
        if (_count == _parts.Length) Array.Resize(ref _parts, Math.Max(2, _count * 2));
        _parts[_count++] = part;
    }

    /// <summary>Adds an ellipse: as arc or circle where it is one in plan, which every machine cuts exactly.</summary>
    public void Add(in EllipseArc ellipse)
    {
        if (ellipse.IsCircular) Add(DrawingPart.Arc(0, ellipse.ToArc(), ellipse.Centre.Z));
        else Add(ellipse.ToCurve());
    }

    public void Add(RationalCurve curve)
    {
        Curves.Add(curve);
        Add(DrawingPart.FreeCurve(0, curve.Kind, Curves.Count - 1));
    }
}
