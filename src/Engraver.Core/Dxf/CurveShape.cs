using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf;

/// <summary>The curve that a record draws, before it goes into the columns. Filled again for every record.</summary>
internal sealed class CurveShape
{
    private DrawingPart[] _parts = new DrawingPart[16];
    private int _count;

    public CurveType Type { get; private set; }

    public bool Closed { get; set; }

    /// <summary>What is odd about the record though it was taken.</summary>
    public List<Trouble> Oddities { get; } = [];

    public ReadOnlySpan<DrawingPart> Parts => _parts.AsSpan(0, _count);

    public Span<DrawingPart> MutableParts => _parts.AsSpan(0, _count);

    /// <summary>The row for the column of entities; its parts are still to be placed.</summary>
    public DrawingEntity ToEntity(EntityRecord record) => new()
    {
        SourceLine = record.Line,
        Handle = record.Handle,
        Layer = record.Layer,
        Type = Type,
        Hidden = record.Invisible,
        Closed = Closed,
    };

    public void Begin(CurveType type)
    {
        Type = type;
        Closed = false;
        _count = 0;
        Oddities.Clear();
    }

    public void Add(in DrawingPart part)
    {
        if (_count == _parts.Length) Array.Resize(ref _parts, _count * 2);
        _parts[_count++] = part;
    }
}
