namespace Engraver.App.Canvas.Colours;

/// <summary>A colour as a drawing states it: by layer, by block, an index of the AutoCAD palette or a true colour. <c>default</c> is by layer.</summary>
public readonly record struct DrawingColour
{
    private readonly Form _form;
    private readonly uint _value;

    private DrawingColour(Form form, uint value) => (_form, _value) = (form, value);

    private enum Form : byte
    {
        ByLayer,
        ByBlock,
        Index,
        True,
    }

    public static DrawingColour ByLayer => default;

    public static DrawingColour ByBlock => new(Form.ByBlock, 0);

    /// <summary>DXF code 62: 0 by block, 256 by layer, 1 to 255 an index; a layer that is off has it negative.</summary>
    public static DrawingColour FromCode62(int value) => Math.Abs(value) switch
    {
        0 => ByBlock,
        var index and <= 255 => new DrawingColour(Form.Index, (uint)index),
        _ => ByLayer,
    };

    /// <summary>DXF code 420: 0x00RRGGBB; it stands above code 62.</summary>
    public static DrawingColour FromCode420(int value) => new(Form.True, (uint)value & 0xFFFFFF);

    /// <summary>The colour with by layer and by block replaced by what stands around: by block takes the insert's own colour, by layer that of the layer.</summary>
    /// <param name="layer">Colour of the layer; never by layer or by block (then index 7).</param>
    /// <param name="insert">Colour of the insert, already resolved; outside blocks index 7.</param>
    public DrawingColour Resolved(DrawingColour layer, DrawingColour insert) => _form switch
    {
        Form.ByLayer => layer.OrForeground(),
        Form.ByBlock => insert.OrForeground(),
        _ => this,
    };

    /// <summary>Index 1 to 255; null for a true colour or one that is not resolved.</summary>
    public int? Index => _form == Form.Index ? (int)_value : null;

    /// <summary>0x00RRGGBB; null for an index or one that is not resolved.</summary>
    public uint? Rgb => _form == Form.True ? _value : null;

    private DrawingColour OrForeground() => _form is Form.Index or Form.True ? this : new DrawingColour(Form.Index, AciPalette.Foreground);
}
