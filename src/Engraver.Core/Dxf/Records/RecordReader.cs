using System.Globalization;
using System.Text;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Tags;
using Engraver.Core.TextMarkup;

namespace Engraver.Core.Dxf.Records;

/// <summary>Reads pairs into records: everything from one group code 0 to the next.</summary>
internal sealed class RecordReader
{
    private const int ShownValue = 40;

    /// <summary>Group code that names a variable of the header.</summary>
    private const int VariableCode = 9;

    /// <summary>Group code that begins the extended data of an application.</summary>
    private const int ApplicationName = 1001;

    private static readonly byte[] s_own = Encoding.ASCII.GetBytes(RestoredInserts.Application);

    private readonly DxfTagSource _tags;
    private readonly NameTable _types = new(bytes => Encoding.Latin1.GetString(bytes).ToUpperInvariant());
    private readonly List<RecordKind> _kinds = [];
    private readonly CancellationToken _cancellation;
    private readonly int _layerZero;
    private int _nextType;
    private double _reportedProgress;

    private readonly TextDecoding _decode;
    private readonly CutChoice _cut;
    private readonly ImportLog _log;

    public RecordReader(DxfTagSource tags, NameTable layers, NameTable blocks, TextDecoding decode, CutChoice cut, ImportLog log, CancellationToken cancellation)
    {
        _log = log;
        _cut = cut;
        _decode = decode;
        _tags = tags;
        _cancellation = cancellation;
        Layers = layers;
        Blocks = blocks;
        Linetypes = new NameTable(bytes => CharacterEscapes.Resolved(decode(bytes)));
        foreach (var standard in Linetype.Standard) Linetypes.IdOf(standard.Name);
        _layerZero = layers.IdOf("0");
        SkipSilently();
    }

    public NameTable Layers { get; }

    public NameTable Blocks { get; }

    public NameTable Linetypes { get; }

    /// <summary>The type names found, by the numbers in the records.</summary>
    public NameTable Types => _types;

    /// <summary>Kind of the next record; <see cref="RecordKind.FileEnd"/> also where the file stops without EOF.</summary>
    public RecordKind Next { get; private set; }

    /// <summary>True when the bytes ran out before EOF.</summary>
    public bool Truncated { get; private set; }

    /// <summary>Line (binary: byte offset) of the next record.</summary>
    public int NextLine { get; private set; }

    /// <summary>Receives the part of the file that has been read; null for none.</summary>
    public IProgress<double>? Progress { get; init; }

    /// <summary>The next record's type name, in capitals.</summary>
    public string NextType => _types[_nextType];

    /// <summary>A position in the next record, after its type: <see cref="DxfTagSource.Return"/> goes back to it, and <see cref="SkipSilently()"/> then
    /// skips to
    /// the record after.</summary>
    public (int Position, int Line) Bookmark() => _tags.Bookmark();

    /// <summary>Reads the whole next record, of any kind.</summary>
    public void Read(EntityRecord record)
    {
        _cancellation.ThrowIfCancellationRequested();
        if (Progress is { } progress) ReportProgress(progress);
        record.Begin(Next, _types[_nextType], _nextType, NextLine, _layerZero);
        var (damages, start) = (_tags.DamageCount, _tags.Bookmark());
        while (_tags.Read() && _tags.Code != 0) Accept(record);
        if (record.IsMergedFromTwo || (record.DoubledCode != 0 && NamesRecord(start))) record.Refuse(DxfRules.TwoRecords, record.Line, record.DoubledCode.ToString(CultureInfo.InvariantCulture));
        ReadNextType();
        if (_tags.DamageCount != damages) record.Refuse(DxfRules.DamagedRecord, _tags.DamageLine, _tags.DamageText);
        if (Truncated && _tags.CutInsidePair) record.Refuse(DxfRules.CutRecord, record.Line, "");
    }

    /// <summary>Skips the next record, which has no relevant content. Reports group codes that cannot be its own, because another record is then lost in
    /// it.</summary>
    public void Skip() => Skip(Next, NextType);

    /// <summary>Skips the rest of the head of TABLES, BLOCKS or ENTITIES, whose name has been read.</summary>
    public void SkipHead() => Skip(RecordKind.Section, "SECTION");

    private void Skip(RecordKind kind, string type)
    {
        _cancellation.ThrowIfCancellationRequested();
        ReportNameless();
        var damages = _tags.DamageCount;
        var (variables, foreign) = (false, default(RecordIssue?));
        while (_tags.Read() && _tags.Code != 0)
        {
            variables |= kind == RecordKind.SectionEnd && _tags.Code == VariableCode; // some programs end the header too early
            if (foreign is not null || variables || RecordKinds.MayHold(kind, type, _tags.Code)) continue;
            foreign = new RecordIssue(DxfRules.RecordMayBeLost, type, 0, _tags.Line, Wording.Get("RecordReader.GroupNotValid", _tags.Code, ShownText()), Refused: true);
        }

        if (_tags.DamageCount != damages && !_tags.IsBinary) foreign = new RecordIssue(DxfRules.RecordMayBeLost, type, 0, _tags.DamageLine, Wording.Get("RecordReader.NotGroupCode", _tags.DamageText), Refused: true);
        if (foreign is { } trouble) _log.Add(trouble);
        ReadNextType();
    }

    /// <summary>Skips the next record without a report: it is read later, or its section is not part of the drawing.</summary>
    public void SkipSilently()
    {
        _cancellation.ThrowIfCancellationRequested();
        ReportNameless();
        while (_tags.Read() && _tags.Code != 0)
        {
        }

        ReadNextType();
    }

    /// <summary>Reports a record without a name, which no program writes: zeros in a binary file are read as one, and the data that they overwrote is
    /// lost.</summary>
    private void ReportNameless()
    {
        if (_types.Count > 0 && Next == RecordKind.Unknown && NextType.Length == 0) _log.Add(new RecordIssue(DxfRules.NameDamaged, "", 0, NextLine, DamagedName.Fault("")!, Refused: true));
    }

    /// <summary>Reads the record that has just been read again: true when a value in it is the name of a record type, and the 0 before it may have been
    /// lost.</summary>
    private bool NamesRecord((int Position, int Line) start)
    {
        var (end, found) = (_tags.Bookmark(), false);
        _tags.Return(start);
        while (!found && _tags.Bookmark().Position < end.Position && _tags.Read()) found = _tags.Code is > 0 and < 10 && RecordKinds.Find(Encoding.Latin1.GetString(_tags.Value.Trim(" \t"u8))) != RecordKind.Unknown;
        _tags.Return(start);
        while (_tags.Bookmark().Position < end.Position && _tags.Read())
        {
        }

        if (_tags.Code != 0) _tags.Read(); // at the end of the file
        return found;
    }

    /// <summary>Skips the pairs up to the next record and passes each to <paramref name="take"/>: the HEADER section has no records.</summary>
    public void Skip(Action<DxfTagSource> take)
    {
        while (_tags.Read() && _tags.Code != 0) take(_tags);
        ReadNextType();
    }

    private void ReportProgress(IProgress<double> progress)
    {
        const double Step = 0.01;
        if (_tags.Part < _reportedProgress + Step) return;
        progress.Report(_reportedProgress = _tags.Part);
    }

    /// <summary>Reads the name of the section that begins here, in capitals. One of the Skip methods must be called next.</summary>
    public string EnterSection() => _tags.Read() ? Encoding.Latin1.GetString(_tags.Value.Trim(" \t"u8)).ToUpperInvariant() : "";

    private void ReadNextType()
    {
        Truncated = _tags.AtEnd;
        NextLine = _tags.Line;
        if (Truncated)
        {
            Next = RecordKind.FileEnd;
            return;
        }

        _nextType = _types.IdOf(_tags.Value);
        while (_kinds.Count < _types.Count) _kinds.Add(RecordKinds.Find(_types[_kinds.Count]));
        Next = _kinds[_nextType];
        if (Next == RecordKind.Section && !BeginsSection()) Next = RecordKind.Unknown;
    }

    /// <summary>True for a section. The section plane of AutoCAD 2007 is an entity that is also called SECTION, but only a section is followed by its
    /// name.</summary>
    private bool BeginsSection()
    {
        var here = _tags.Bookmark();
        var named = _tags.Read() && _tags.Code == 2;
        _tags.Return(here);
        return named;
    }

    private void Accept(EntityRecord record)
    {
        if (_tags.Code == 10) record.CountPlace();
        switch (_tags.Code)
        {
            case 5 when record.Handle == 0:
                record.Handle = HandleText.Parse(_tags.Value);
                break;
            case 8 when record.Kind is not RecordKind.LayerEntry:
                record.Count(8);
                record.Layer = Layers.IdOf(_tags.Value);
                break;
            case 2 when record.Kind is RecordKind.Insert or RecordKind.Block || (record.Kind is RecordKind.Dimension && _cut.HasFlag(CutChoice.Dimension)):
                record.Count(2);
                record.Name = Blocks.IdOf(_tags.Value);
                break;
            case 2 when record.Kind is RecordKind.LayerEntry:
                record.Count(2);
                record.Name = Layers.IdOf(_tags.Value);
                break;
            case 2 when record.Kind is RecordKind.LinetypeEntry:
                record.Name = Linetypes.IdOf(_tags.Value);
                break;
            case 40 when record.Kind is RecordKind.LinetypeEntry:
                if (_tags.TryNumber(out var pattern)) record.Set(40, pattern);
                break;
            case 49 or 74 when record.Kind is RecordKind.LinetypeEntry:
                if (_tags.TryNumber(out var element)) record.Sequence.Add(new CodedNumber(_tags.Code, element));
                break;
            case ApplicationName when RecordKinds.HasLinetype(record.Kind):
                record.BeginExtended(_tags.Value.Trim(" \t"u8).SequenceEqual(s_own));
                break;
            case >= 1000 when record.IsInOwn:
                record.CollectOwn(_tags, _decode);
                break;
            case 6 when record.Kind is RecordKind.LayerEntry || RecordKinds.HasLinetype(record.Kind):
                record.Linetype = Linetypes.IdOf(_tags.Value);
                break;
            case 48 when RecordKinds.HasLinetype(record.Kind):
                if (_tags.TryNumber(out var scale) && scale > 0.0) record.LinetypeScale = scale;
                break;
            case 370 when RecordKinds.HasLineweight(record.Kind):
                if (record.Lineweight is null && _tags.TryNumber(out var weight)) record.Lineweight = weight is >= Lineweight.Default and <= Lineweight.Heaviest ? (int)weight : Lineweight.Default;
                break;
            default:
                if (RecordKinds.IsCollected(record.Kind, _cut)) Collect(record);
                else AcceptNumber(record, _tags.Code);
                break;
        }
    }

    /// <summary>Reads a record pair by pair. A damaged number of an outline refuses it, because it would change the cut; a text keeps its group.</summary>
    private void Collect(EntityRecord record)
    {
        if (record.Collect(_tags, _decode)) return;
        if (TryOddNumber(record, _tags.Code, out var value)) record.Collect(_tags.Code, value);
        else if (RecordKinds.IsOutline(record.Kind)) RefuseValue(record, _tags.Code);
        else if (record.DamagedGroup == 0) record.DamagedGroup = _tags.Code;
    }

    private void RefuseValue(EntityRecord record, int code) =>
        record.Refuse(DxfRules.BadValue, _tags.ValueLine, Wording.Get("RecordReader.Group", code, ShownText()));

    private void AcceptNumber(EntityRecord record, int code)
    {
        if (record.Kind == RecordKind.Point && EntityRecord.Keeps(code) && code is not (60 or 67))
        {
            if (!record.Has(code) && _tags.TryNumber(out var shown)) record.Set(code, shown); // only shown: a damaged number has no effect
            return;
        }

        if (!EntityRecord.Keeps(code) || !(RecordKinds.HasNumbers(record.Kind) || code is 60 or 67)) return;
        var repeats = (record.Kind == RecordKind.LwPolyline && code is 10 or 20 or 30 or 40 or 41 or 42) || (record.Kind == RecordKind.Spline && code is 10 or 20 or 30 or 11 or 21 or 31 or 40 or 41);
        if (!_tags.TryNumber(out var value) && !TryOddNumber(record, code, out value))
        {
            if (code != EntityRecord.TrueColour) RefuseValue(record, code);
        }
        else if (repeats)
        {
            record.Sequence.Add(new CodedNumber(code, value));
        }
        else
        {
            record.Set(code, value);
        }
    }

    /// <summary>Reads a decimal comma or a Fortran exponent: not DXF, but with only one possible meaning.</summary>
    private bool TryOddNumber(EntityRecord record, int code, out double value)
    {
        value = 0.0;
        if (_tags.IsBinary || !ForeignNumber.TryParse(_tags.Value, out value)) return false;
        record.Warning ??= record.Finding(DxfRules.OddNumber, Wording.Get("RecordReader.GroupReadAs", ShownText(), code, value), refused: false) with { Line = _tags.ValueLine };
        return true;
    }

    private string ShownText() => _tags.IsBinary
        ? Convert.ToHexString(_tags.Value[..Math.Min(_tags.Value.Length, ShownValue)])
        : Encoding.Latin1.GetString(_tags.Value[..Math.Min(_tags.Value.Length, ShownValue)]);
}
