namespace Engraver.Core.Drawings;

/// <summary>A colour as a drawing states it: by layer, by block, an index of the AutoCAD palette or a true colour. <c>default</c> is by layer.</summary>
/// <remarks>One number, because every entity of a drawing has one: 0 by layer, 1 to 255 an index, 256 by block, from 2^24 upwards a true colour.</remarks>
public readonly record struct DrawingColour
{
    private const int LastIndex = 255;
    private const int BlockValue = 256;
    private const int TrueValue = 1 << 24;
    private readonly int _value;

    private DrawingColour(int value) => _value = value;

    public static DrawingColour ByLayer => default;

    public static DrawingColour ByBlock => new(BlockValue);

    /// <summary>Index 7: white on dark, black on light.</summary>
    public static DrawingColour Foreground => new(7);

    /// <summary>Code 62 as written: 0 by block, 256 by layer, else the index; null for a true colour.</summary>
    public int? Code62 => IsByLayer ? 256 : IsByBlock ? 0 : Index;

    public bool IsByLayer => _value == 0;

    public bool IsByBlock => _value == BlockValue;

    /// <summary>Index 1 to 255; null for a true colour or an unresolved one.</summary>
    public int? Index => _value is > 0 and <= LastIndex ? _value : null;

    /// <summary>0x00RRGGBB; null for an index or an unresolved colour.</summary>
    public uint? Rgb => _value >= TrueValue ? (uint)(_value - TrueValue) : null;

    /// <summary>DXF code 62: 0 by block, 256 by layer, 1 to 255 an index; negative for a layer that is off.</summary>
    public static DrawingColour FromCode62(int value) => value switch
    {
        0 => ByBlock,
        >= -LastIndex and <= LastIndex => new DrawingColour(Math.Abs(value)),
        _ => ByLayer,
    };

    /// <summary>DXF code 420: 0x00RRGGBB; it has precedence over code 62.</summary>
    public static DrawingColour FromCode420(int value) => new(TrueValue + (value & 0xFFFFFF));

    /// <summary>The colour with "by layer" replaced by the layer's colour and "by block" by the insert's.</summary>
    /// <param name="layer">Colour of the layer; never by layer or by block (then index 7).</param>
    /// <param name="insert">Colour of the insert, already resolved; outside blocks index 7.</param>
    public DrawingColour Resolved(DrawingColour layer, DrawingColour insert) => _value switch
    {
        0 => layer.OrForeground(),
        BlockValue => insert.OrForeground(),
        _ => this,
    };

    /// <summary>The colour itself, or index 7 for "by layer" and "by block".</summary>
    public DrawingColour OrForeground() => _value is 0 or BlockValue ? Foreground : this;
}
