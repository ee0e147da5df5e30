using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>The curve that a record draws, before it is stored in the columns. Reused for every record.</summary>
internal sealed class CurveShape
{
    /// <summary>Empty at first: a hatch may have a million loops, each with its own shape.</summary>
    private DrawingPart[] _parts = [];
    private int _count;

    public CurveType Type { get; private set; }

    public bool Closed { get; set; }

    /// <summary>Findings about the record, which was accepted nevertheless.</summary>
    public List<RecordIssue> Warnings { get; } = [];

    public ReadOnlySpan<DrawingPart> Parts => _parts.AsSpan(0, _count);

    /// <summary>Ellipses and splines that its parts refer to.</summary>
    public List<RationalCurve> Curves { get; } = [];

    public Span<DrawingPart> MutableParts => _parts.AsSpan(0, _count);

    /// <summary>False when a factor (a ratio, a bulge, a weight) made a value too large to compute with, though every number in the record was
    /// usable.</summary>
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

    /// <summary>The row for the column of entities; the position of its parts is filled in later.</summary>
    public DrawingEntity ToEntity(EntityRecord record) => new()
    {
        SourceLine = record.Line,
        Handle = record.Handle,
        Layer = record.Layer,
        Colour = record.Colour,
        LineStyle = record.LineStyle,
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
        Warnings.Clear();
    }

    public void Add(in DrawingPart part)
    {
        if (_count == _parts.Length) Array.Resize(ref _parts, Math.Max(2, _count * 2));
        _parts[_count++] = part;
    }

    /// <summary>Adds an ellipse; as an arc or circle where it is one in plan, because every machine cuts those exactly.</summary>
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
