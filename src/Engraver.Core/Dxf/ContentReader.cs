using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Blocks;
using Engraver.Core.Dxf.Lengths;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Dxf.Text;

namespace Engraver.Core.Dxf;

/// <summary>Reads the entities of a block or of model space, each with the records that belong to it, and passes them to a target.</summary>
internal sealed class ContentReader(RecordReader records, TextMapper texts, OutlineMapper outlines, LengthCheck lengths, LinetypeTable linetypes, LineStyleTable styles, CutChoice cut, CutChoice areas)
{
    private readonly EntityRecord _record = new();
    private readonly EntityRecord _part = new();
    private readonly CurveMapper _mapper = new();
    private readonly List<PlacedText> _attributes = [];

    /// <summary>Reads the next record and its parts. The caller has checked that it is not the end of a block, section or file.</summary>
    public void ReadEntity(IContentTarget target)
    {
        records.Read(_record);
        var attributes = 0;
        if (_record.Kind == RecordKind.Polyline) ReadVertices();
        if (_record.Kind == RecordKind.Insert) attributes = ReadAttributes();
        if (!target.Accepts(_record)) return;
        if (_record.Kind == RecordKind.Insert) AddInsert(target, attributes);
        else if (DrawsCurve()) AddCurve(target);
        else if (_record.Kind == RecordKind.Dimension && cut.HasFlag(CutChoice.Dimension)) AddDimension(target);
        else if ((RecordKinds.ChoiceOf(_record.Kind) & (cut | areas)) != 0) AddOutlines(target);
        else AddOther(target);
    }

    /// <summary>Maps the record when its type is a curve; false when it is not.</summary>
    private bool DrawsCurve()
    {
        switch (_record.Kind)
        {
            case RecordKind.Line:
                _mapper.Line(_record);
                return true;
            case RecordKind.Arc:
                _mapper.Arc(_record);
                return true;
            case RecordKind.Circle:
                _mapper.Circle(_record);
                return true;
            case RecordKind.Ellipse:
                _mapper.Ellipse(_record);
                return true;
            case RecordKind.Spline:
                _mapper.Spline(_record);
                return true;
            case RecordKind.LwPolyline:
                _mapper.LwPolyline(_record, records.Truncated);
                return true;
            case RecordKind.Polyline:
                _mapper.FinishPolyline(_record);
                return true;
            default:
                return false;
        }
    }

    private void AddCurve(IContentTarget target)
    {
        if (_record.Fault is { } fault)
        {
            target.Refuse(_record, fault);
            return;
        }

        if (lengths.Find(_record, _mapper.Shape) is { } lost) _mapper.Shape.Warnings.Add(lost);
        _record.LineStyle = styles.NumberOf(_record);
        if (linetypes.Find(_record) is { } dashed) _mapper.Shape.Warnings.Add(dashed);
        target.AddCurve(_record, _mapper.Shape);
    }

    private void AddInsert(IContentTarget target, int attributes)
    {
        if (_record.Name < 0) _record.Required(2);
        var insert = new BlockInsert(_record);
        if (_record.Fault is { } fault) target.Refuse(_record, fault);
        else target.AddInsert(_record, insert, attributes);
        if (_record.Warning is { } odd) target.Note(odd);
        if (insert.ZeroScaleCode is not 0 and var code) target.Note(_record.Finding(DxfRules.ZeroScale, Wording.Get("ContentReader.Group", code), refused: false));
        foreach (var text in _attributes) target.AddText(text);
    }

    /// <summary>A dimension is an insert of its own block, whose content is in its place already (DXF reference, "DIMENSION", groups 2 and 12).</summary>
    private void AddDimension(IContentTarget target)
    {
        if (_record.Name < 0) _record.Required(2);
        if (_record.Fault is { } fault) target.Refuse(_record, fault);
        else target.AddInsert(_record, BlockInsert.OfDimension(_record), attributes: 0);
        if (_record.Warning is { } odd) target.Note(odd);
    }

    private void AddOutlines(IContentTarget target)
    {
        outlines.Map(_record);
        _record.LineStyle = styles.NumberOf(_record);
        List<RecordIssue> lost = _record.Fault is null ? [.. lengths.FindAll(_record, outlines.Shapes)] : [];
        outlines.Finish(_record);
        if (_record.Fault is { } fault) target.Refuse(_record, fault);
        else if ((RecordKinds.ChoiceOf(_record.Kind) & areas) != 0) target.AddAreas(_record, outlines.Shapes);
        else target.AddCurves(_record, outlines.Shapes);
        if (_record.Warning is { } odd) target.Note(odd);
        foreach (var issue in lost) target.Note(issue);
    }

    private void AddOther(IContentTarget target)
    {
        if (_record.Fault is null)
        {
            switch (_record.Kind)
            {
                case RecordKind.Vertex or RecordKind.SequenceEnd:
                    _record.Refuse(DxfRules.PartAlone, _record.Line, "");
                    break;
                case RecordKind.Text or RecordKind.Attribute:
                    target.AddConstruction(_record);
                    if (texts.Map(_record) is { } text) target.AddText(text);
                    return;
                case RecordKind.Point:
                    target.AddConstruction(_record);
                    if (PlacedPoints.Map(_record) is { } point) target.AddPoint(point);
                    return;
                case RecordKind.AttributeDefinition:
                    target.AddConstruction(_record);
                    if (texts.MapConstant(_record) is { } constant) target.AddConstant(_record, constant);
                    return;
                case RecordKind.Construction:
                case var kind when RecordKinds.IsOutline(kind):
                    target.AddConstruction(_record);
                    return;
                default:
                    if (DamagedName.Fault(_record.Type) is { } damage) _record.Refuse(DxfRules.NameDamaged, _record.Line, damage);
                    else _record.Refuse(DxfRules.TypeNotRead, _record.Line, "");
                    break;
            }
        }

        target.Refuse(_record, _record.Fault!.Value);
    }

    private void ReadVertices()
    {
        _mapper.BeginPolyline();
        lengths.BeginPolyline();
        while (records.Next == RecordKind.Vertex)
        {
            records.Read(_part);
            _mapper.AddVertex(_record, _part);
            lengths.AddVertex(_part);
        }

        if (records.Next == RecordKind.SequenceEnd) records.Skip();
        else if (records.Truncated) _record.Refuse(DxfRules.CutRecord, _record.Line, "");
        else _mapper.NoteMissingEnd(_record);
    }

    /// <summary>The attributes of an INSERT are texts of that copy: counted, but not as separate entities.</summary>
    private int ReadAttributes()
    {
        var count = 0;
        _attributes.Clear();
        for (; records.Next == RecordKind.Attribute; count++)
        {
            records.Read(_part);
            if (_part.Fault is { Rule: var rule } && (rule == DxfRules.TwoRecords || rule == DxfRules.DamagedRecord)) _record.CopyFaultFrom(_part);
            if (texts.Map(_part) is { } text) _attributes.Add(text);
        }

        if (records.Next == RecordKind.SequenceEnd && (count > 0 || _record.Flags(66) == 1)) records.Skip();
        return count;
    }
}
