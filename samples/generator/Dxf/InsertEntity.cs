using Engraver.Samples.Geometry;

namespace Engraver.Samples.Dxf;

/// <summary>A block reference; more than one column or row makes it a rectangular array (MINSERT) laid out along the rotated axes.</summary>
internal sealed record InsertEntity(string Layer, string Block, Point At) : DxfEntity(Layer)
{
    public double ScaleX { get; init; } = 1;

    public double ScaleY { get; init; } = 1;

    /// <summary>Degrees, counter-clockwise.</summary>
    public double Rotation { get; init; }

    public int Columns { get; init; } = 1;

    public int Rows { get; init; } = 1;

    /// <summary>Distance between columns and between rows, in drawing units.</summary>
    public double Spacing { get; init; }
}
