using System.Globalization;
using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>Writes (group code, value) pairs as ASCII DXF; handles are assigned in order. Calls can be chained.</summary>
/// <param name="output">Receives LF as line end; DXF allows LF and CR LF.</param>
/// <param name="firstHandle">The first handle that <see cref="NextHandle"/> returns.</param>
internal sealed class DxfTagWriter(TextWriter output, int firstHandle)
{
    private int _nextHandle = firstHandle;

    /// <summary>False after a number was written that is not finite: the text is then not a valid DXF.</summary>
    public bool IsFinite { get; private set; } = true;

    public DxfTagWriter Text(int code, string value)
    {
        output.Write(code.ToString(CultureInfo.InvariantCulture));
        output.Write('\n');
        output.Write(Ascii.IsValid(value) ? value : Escaped(value));
        output.Write('\n');
        return this;
    }

    /// <summary>Writes every character outside ASCII as \U+XXXX, which AutoCAD and compatible programs read in any code page.</summary>
    private static string Escaped(string value) =>
        string.Concat(value.Select(unit => char.IsAscii(unit) ? unit.ToString() : string.Create(CultureInfo.InvariantCulture, $@"\U+{(int)unit:X4}")));

    public DxfTagWriter Integer(int code, int value) => Text(code, value.ToString(CultureInfo.InvariantCulture));

    public DxfTagWriter Handle(int code, int handle) => Text(code, handle.ToString("X", CultureInfo.InvariantCulture));

    /// <summary>The shortest text that reads back as the same number, always with a point or an exponent; minus zero is written as zero.</summary>
    public DxfTagWriter Real(int code, double value)
    {
        IsFinite &= double.IsFinite(value);
        var text = (value + 0.0).ToString("R", CultureInfo.InvariantCulture);
        return Text(code, text.AsSpan().ContainsAny('.', 'E') ? text : text + ".0");
    }

    /// <summary>A point: the code, code + 10 and code + 20.</summary>
    public DxfTagWriter Point(int code, Point2D place, double z = 0.0) => Real(code, place.X).Real(code + 10, place.Y).Real(code + 20, z);

    public DxfTagWriter Point(int code, Vector3D place) => Real(code, place.X).Real(code + 10, place.Y).Real(code + 20, place.Z);

    /// <summary>Group 100: marker of an object's class.</summary>
    public DxfTagWriter Class(string marker) => Text(100, marker);

    /// <summary>Begins an object with the next free handle.</summary>
    public DxfTagWriter Begin(string type, int owner) => Begin(type, owner, NextHandle());

    public DxfTagWriter Begin(string type, int owner, int handle) => Text(0, type).Handle(type == "DIMSTYLE" ? 105 : 5, handle).Handle(330, owner);

    /// <summary>Begins an entity of model space: writes the pairs that all entities have in common.</summary>
    public DxfTagWriter BeginEntity(string type, string layer, DrawingColour colour, bool hidden, string? linetype = null, double? linetypeScale = null, int? lineweight = null)
    {
        Begin(type, DxfHandles.ModelSpace).Class("AcDbEntity").Text(8, layer);
        if (linetype is not null) Text(6, linetype);
        if (!colour.IsByLayer && colour.Code62 is { } index) Integer(62, index);
        if (colour.Rgb is { } rgb) Integer(EntityRecord.TrueColour, (int)rgb);
        if (lineweight is { } weight) Integer(370, weight);
        if (linetypeScale is { } scale) Real(48, scale);
        if (hidden) Integer(60, 1);
        return this;
    }

    public int NextHandle() => _nextHandle++;

    public void Section(string name, Action<DxfTagWriter> content)
    {
        Text(0, "SECTION").Text(2, name);
        content(this);
        Text(0, "ENDSEC");
    }
}
