using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Blocks;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Dxf.Text;

namespace Engraver.Core.Dxf;

/// <summary>Takes the records of model space: curves are added directly to the drawing's columns, inserts are expanded in their order.</summary>
internal sealed class ModelSpaceContent(CurveColumns columns, BlockExpander expander, BlockPathTable paths, TextExpander texts, PointExpander points, ConstructionTally construction, ReadTally balance, ImportLog log) : IContentTarget
{
    /// <summary>Path of the insert whose attributes may follow; 0 for none.</summary>
    private int _path;

    /// <summary>Records of paper space that would be cut or shown in model space.</summary>
    public int OnPaper { get; private set; }

    public bool Accepts(EntityRecord record)
    {
        _path = 0;
        if (!record.InPaperSpace) return true;
        if (record.Type != "VIEWPORT") OnPaper++;
        return false;
    }

    public void AddCurve(EntityRecord record, CurveShape shape)
    {
        columns.Add(shape.ToEntity(record) with { Insert = expander.Restored(record) }, shape.Parts, shape.Curves);
        balance.AddCut(record);
        foreach (var oddity in shape.Warnings) log.Add(oddity);
    }

    public void AddCurves(EntityRecord record, IReadOnlyList<CurveShape> shapes)
    {
        balance.AddCut(record);
        foreach (var shape in shapes)
        {
            columns.Add(shape.ToEntity(record), shape.Parts, shape.Curves);
            foreach (var oddity in shape.Warnings) log.Add(oddity);
        }
    }

    public void AddAreas(EntityRecord record, IReadOnlyList<CurveShape> shapes)
    {
        AddConstruction(record);
        foreach (var shape in shapes) columns.Add(shape.ToEntity(record), shape.Parts, shape.Curves);
    }

    public void AddText(PlacedText text) => texts.Add(_path == 0 ? text : text with { BlockPath = _path });

    public void AddConstant(EntityRecord record, PlacedText text)
    {
    }

    public void AddPoint(PlacedPoint point) => points.Add(point);

    public void Note(in RecordIssue oddity) => log.Add(oddity);

    public void AddInsert(EntityRecord record, in BlockInsert insert, int attributes)
    {
        if (attributes > 0) balance.AddAnnotation("ATTRIB", attributes);
        _path = paths.Inside(0, insert.Block);
        var before = columns.Count;
        var issue = expander.Expand(insert);
        texts.Expand(insert);
        points.Expand(insert);
        construction.Expand(insert);
        if (columns.Count > before) balance.AddCut(record);
        else if (issue is { } reason) balance.AddRefused(record, reason);
        else balance.AddConstruction(record);
    }

    public void AddConstruction(EntityRecord record)
    {
        balance.AddConstruction(record);
        if (ConstructionTally.Counts(record, inBlock: false)) construction.Add(record);
        if (record.Kind is RecordKind.Text or RecordKind.Point or RecordKind.Attribute) balance.AddAnnotation(record.Type, 1);
    }

    public void Refuse(EntityRecord record, in RecordIssue issue) => balance.AddRefused(record, issue);
}
