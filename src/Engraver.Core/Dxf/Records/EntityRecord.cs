using System.Globalization;
using System.Text;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Tags;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;

namespace Engraver.Core.Dxf.Records;

/// <summary>One record of the file (LINE, VERTEX, LAYER ...): its type and the values that the supported types need. Reused for every record.</summary>
internal sealed class EntityRecord
{
    /// <summary>Group code of a colour as 0x00RRGGBB.</summary>
    public const int TrueColour = 420;

    private const int CodeCount = TrueColour + 1;

    /// <summary>Group code after which the values belong to an object embedded in this one (columns of an MTEXT, the MTEXT of an ATTRIB).</summary>
    private const int EmbeddedObject = 101;

    /// <summary>First group code of extended data; below the second one they are texts.</summary>
    private const int FirstExtended = 1000;

    private const int FirstExtendedNumber = 1010;

    private const int ApplicationName = 1001;

    /// <summary>Codes whose first value is kept: points, sizes, angles, scales, flags, counts, extrusion, colours.</summary>
    private static readonly int[] KeptCodes =
        [10, 11, 12, 13, 20, 21, 22, 23, 30, 31, 32, 33, 38, 40, 41, 42, 43, 44, 45, 50, 51, 60, 62, 66, 67, 70, 71, 90, 210, 220, 230, 290, TrueColour];

    private static readonly sbyte[] Slots = BuildSlots();

    private readonly double[] _values = new double[KeptCodes.Length];
    private ulong _seen;
    private bool _embedded;
    private bool _extra;
    private uint _counted;
    private bool _placed;
    private bool _placedAgain;

    public RecordKind Kind { get; private set; }

    public int TypeId { get; private set; }

    public string Type { get; private set; } = "";

    /// <summary>Line at which the record begins.</summary>
    public int Line { get; private set; }

    public ulong Handle { get; set; }

    public int Layer { get; set; }

    /// <summary>Number of the block or layer it names (code 2); -1 without one.</summary>
    public int Name { get; set; }

    /// <summary>The first group of a text whose number cannot be used; 0 if all can.</summary>
    public int DamagedGroup { get; set; }

    /// <summary>Number of its linetype (code 6); by layer where none is named.</summary>
    public int Linetype { get; set; }

    /// <summary>Scale of the pattern of its linetype (code 48).</summary>
    public double LinetypeScale { get; set; }

    /// <summary>Its lineweight (code 370), as stated; null where none is stated.</summary>
    public int? Lineweight { get; set; }

    /// <summary>Constant width of a polyline, drawing units; 0 for none, NaN for one that varies.</summary>
    public double Width { get; set; }

    /// <summary>Number of its line style.</summary>
    public int LineStyle { get; set; }

    /// <summary>A code that appeared twice, 0 when none did.</summary>
    public int RepeatedCode { get; private set; }

    /// <summary>Group code of a name or layer that is in the record more than once; 0 when none is.</summary>
    public int DoubledCode { get; private set; }

    /// <summary>True when two records have been merged because the head of the second is lost: after a doubled code a value or another point is
    /// repeated.</summary>
    public bool IsMergedFromTwo => DoubledCode != 0 && (_placedAgain || RepeatedCode != 0);

    /// <summary>The first value that could not be read: the record must then be refused.</summary>
    public RecordIssue? Fault { get; private set; }

    /// <summary>A finding about the spelling of one of its values that could be read nevertheless; null for none.</summary>
    public RecordIssue? Warning { get; set; }

    /// <summary>Texts in file order, for records that are kept pair by pair; a 100 is also in <see cref="Sequence"/>, with its index here.</summary>
    public List<CodedText> Texts { get; } = [];

    /// <summary>Numbers of the object embedded in a text (columns of an MTEXT), in file order.</summary>
    public List<CodedNumber> Embedded { get; } = [];

    /// <summary>Extended data of a text or a text style, in file order; a 1001 begins that of an application.</summary>
    public List<ExtendedValue> Extended { get; } = [];

    /// <summary>Extended data of this package, in file order; null for none.</summary>
    public List<ExtendedValue>? Own { get; private set; }

    /// <summary>Numbers in file order, for types in which codes repeat.</summary>
    public List<CodedNumber> Sequence { get; } = [];

    public bool InPaperSpace => Number(67, 0.0) == 1.0;

    public bool Invisible => Number(60, 0.0) == 1.0;

    /// <summary>As written; a true colour has precedence over an index.</summary>
    public DrawingColour Colour => Has(TrueColour) ? DrawingColour.FromCode420(Bits(TrueColour)) : Has(62) ? DrawingColour.FromCode62(Flags(62)) : default;

    public static bool Keeps(int code) => (uint)code < CodeCount && Slots[code] >= 0;

    public void Begin(RecordKind kind, string type, int typeId, int line, int layer)
    {
        Kind = kind;
        TypeId = typeId;
        Type = type;
        Line = line;
        Layer = layer;
        Handle = 0;
        Name = -1;
        DamagedGroup = 0;
        Linetype = Drawings.Linetype.ByLayer;
        LinetypeScale = 1.0;
        (Lineweight, Width) = (null, 0.0);
        LineStyle = 0;
        Own = null;
        RepeatedCode = 0;
        DoubledCode = 0;
        _counted = 0;
        (_placed, _placedAgain) = (kind == RecordKind.Polyline, false); // its points are those of its vertices
        Fault = null;
        Warning = null;
        if (_extra)
        {
            Embedded.Clear();
            Extended.Clear();
        }

        (_embedded, _extra) = (false, false);
        IsInOwn = false;
        Texts.Clear();
        Sequence.Clear();
        _seen = 0;
    }

    /// <summary>Counts a code below 32, of which a record may have only one.</summary>
    public void Count(int code)
    {
        if ((_counted & (1u << code)) != 0) DoubledCode = code;
        _counted |= 1u << code;
    }

    /// <summary>Records that a point begins (code 10), of which a record may have many, but none after a doubled code.</summary>
    public void CountPlace()
    {
        if (DoubledCode == 0) _placed = true;
        else if (_placed) _placedAgain = true;
    }

    /// <summary>Keeps the value of a code for which <see cref="Keeps"/> holds. The first one counts: a repetition is part of the damage.</summary>
    public void Set(int code, double value)
    {
        var slot = Slots[code];
        var bit = 1ul << slot;
        if ((_seen & bit) != 0)
        {
            RepeatedCode = code;
            return;
        }

        _seen |= bit;
        _values[slot] = value;
    }

    /// <summary>Keeps the pair in file order, and of a kept code also the first value. A value that is not a number is left out.</summary>
    /// <returns>False for a value that should be a number but is not: it affects the cut, unless the record is only shown.</returns>
    public bool Collect(DxfTagSource tags, TextDecoding decode)
    {
        var code = tags.Code;
        if (code >= FirstExtended || _embedded || code == EmbeddedObject)
        {
            if (Kind is RecordKind.Text or RecordKind.StyleEntry) CollectExtra(tags, decode);
            _embedded |= code == EmbeddedObject;
            return true;
        }

        if (code is 1 or 2 or 3 or 4 or 7 or 100)
        {
            if (code == 100) Sequence.Add(new CodedNumber(code, Texts.Count));
            Texts.Add(new CodedText(code, decode(tags.Value)));
            return true;
        }

        if (code == TrueColour && tags.TryNumber(out var colour) && !Has(code)) Set(code, colour);
        if (code is not ((>= 10 and < 100) or (>= 210 and <= 230))) return true;
        if (!tags.TryNumber(out var value)) return false;
        Collect(code, value);
        return true;
    }

    private void CollectExtra(DxfTagSource tags, TextDecoding decode)
    {
        var code = tags.Code;
        _extra = true;
        if (code is >= FirstExtended and < FirstExtendedNumber) Extended.Add(new ExtendedValue(code, CharacterEscapes.Resolved(decode(tags.Value)), 0.0));
        else if (code >= FirstExtendedNumber && tags.TryNumber(out var value)) Extended.Add(new ExtendedValue(code, "", value));
        else if (_embedded && code is >= 10 and < 100 && tags.TryNumber(out var number)) Embedded.Add(new CodedNumber(code, number));
    }

    /// <summary>True while the values belong to the extended data of this package.</summary>
    public bool IsInOwn { get; private set; }

    /// <summary>Begins the extended data of an application.</summary>
    public void BeginExtended(bool isOwn)
    {
        IsInOwn = isOwn;
        if (isOwn) Own ??= [];
    }

    /// <summary>Keeps a value of the extended data of this package; one that is not a number is left out.</summary>
    public void CollectOwn(DxfTagSource tags, TextDecoding decode)
    {
        if (tags.Code < FirstExtendedNumber) Own!.Add(new ExtendedValue(tags.Code, CharacterEscapes.Resolved(decode(tags.Value)), 0.0));
        else if (tags.TryNumber(out var value)) Own!.Add(new ExtendedValue(tags.Code, "", value));
    }

    /// <summary>The extended data of an application, without its name.</summary>
    public IEnumerable<ExtendedValue> ExtendedOf(string application)
    {
        var isOwn = false;
        foreach (var value in Extended)
        {
            if (value.Code == ApplicationName) isOwn = value.Text.Trim().Equals(application, StringComparison.OrdinalIgnoreCase);
            else if (isOwn) yield return value;
        }
    }

    /// <summary>Keeps a number in file order.</summary>
    public void Collect(int code, double value)
    {
        Sequence.Add(new CodedNumber(code, value));
        if (Keeps(code) && !Has(code)) Set(code, value);
    }

    /// <summary>The texts of these codes joined in file order, \U+ and \M+ resolved; "" when there is none.</summary>
    public string TextOf(params ReadOnlySpan<int> codes) => CharacterEscapes.Resolved(RawOf(codes));

    /// <summary>As <see cref="TextOf"/>, as written.</summary>
    public string RawOf(params ReadOnlySpan<int> codes)
    {
        var joined = "";
        StringBuilder? pieces = null;
        foreach (var text in Texts)
        {
            if (!codes.Contains(text.Code)) continue;
            if (joined.Length == 0 && pieces is null) joined = text.Raw;
            else (pieces ??= new StringBuilder(joined)).Append(text.Raw);
        }

        return pieces?.ToString() ?? joined;
    }

    /// <summary>The first value of a code of a collected record.</summary>
    public double First(int code, double otherwise)
    {
        foreach (var coded in Sequence)
        {
            if (coded.Code == code) return coded.Value;
        }

        return otherwise;
    }

    /// <summary>The first value of a code of a collected record as a flag word or count; 0 where it is not stated or does not fit.</summary>
    public int FirstFlags(int code, int otherwise = 0) => First(code, otherwise) is var value && Math.Abs(value) <= int.MaxValue ? (int)value : 0;

    public bool Has(int code) => (_seen & (1ul << Slots[code])) != 0;

    /// <summary>The value of a code that may be missing.</summary>
    public double Number(int code, double otherwise) => Has(code) ? _values[Slots[code]] : otherwise;

    /// <summary>A flag word; a value that does not fit is read as 0.</summary>
    public int Flags(int code) => Number(code, 0.0) is var value && Math.Abs(value) <= int.MaxValue ? (int)value : 0;

    /// <summary>A 32-bit word, which some programs write signed and some unsigned.</summary>
    private int Bits(int code) => Number(code, 0.0) is var value && Math.Abs(value) <= uint.MaxValue ? unchecked((int)(long)value) : 0;

    /// <summary>The value of a code that the record needs; a missing one becomes the <see cref="Fault"/>.</summary>
    public double Required(int code)
    {
        if (Has(code)) return _values[Slots[code]];
        Refuse(DxfRules.MissingValue, Line, code.ToString(CultureInfo.InvariantCulture));
        return 0.0;
    }

    /// <summary>The point of codes (<paramref name="xCode"/>, +10, +20); z may be missing.</summary>
    public Vector3D Point(int xCode) => new(Required(xCode), Required(xCode + 10), Number(xCode + 20, 0.0));

    /// <summary>As <see cref="Point"/>, for a record that is not refused when coordinates are missing: they are then 0.</summary>
    public Vector3D PointOrOrigin(int xCode) => new(Number(xCode, 0.0), Number(xCode + 10, 0.0), Number(xCode + 20, 0.0));

    public Vector3D Extrusion() => new(Number(210, 0.0), Number(220, 0.0), Number(230, 1.0));

    public void Refuse(DiagnosticRule rule, int line, string detail) => Fault ??= Finding(rule, detail, refused: true) with { Line = line };

    /// <summary>Makes the fault of a part (a VERTEX) the fault of the whole.</summary>
    public void CopyFaultFrom(EntityRecord part)
    {
        if (part.Fault is { } fault) Refuse(fault.Rule, fault.Line, fault.Detail);
        Warning ??= part.Warning;
    }

    public RecordIssue Finding(DiagnosticRule rule, string detail, bool refused) => new(rule, Type, Handle, Line, detail, refused);

    private static sbyte[] BuildSlots()
    {
        var slots = new sbyte[CodeCount];
        Array.Fill(slots, (sbyte)-1);
        for (var slot = 0; slot < KeptCodes.Length; slot++) slots[KeptCodes[slot]] = (sbyte)slot;
        return slots;
    }
}

/// <summary>A text with its group code.</summary>
/// <param name="Raw">As written, bytes decoded.</param>
internal readonly record struct CodedText(int Code, string Raw)
{
    /// <summary>With \U+ and \M+ resolved.</summary>
    public string Value => CharacterEscapes.Resolved(Raw);
}
