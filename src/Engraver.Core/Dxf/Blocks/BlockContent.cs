using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Fills a block definition.</summary>
internal sealed class BlockContent(BlockDefinition block, CurveColumns columns, ReadTally balance) : IContentTarget
{
    public bool Accepts(EntityRecord record) => true;

    public void AddCurve(EntityRecord record, CurveShape shape)
    {
        columns.Add(shape.ToEntity(record), shape.Parts, shape.Curves);
        block.EndCurve = columns.Count;
        foreach (var curve in shape.Curves) block.ExtraSteps += (long)curve.Spans.Length * (curve.Spans[0].Degree + 1) / 2;
        block.Issues.AddRange(shape.Warnings);
    }

    public void AddCurves(EntityRecord record, IReadOnlyList<CurveShape> shapes)
    {
        foreach (var shape in shapes) AddCurve(record, shape);
    }

    public void AddAreas(EntityRecord record, IReadOnlyList<CurveShape> shapes)
    {
        AddConstruction(record);
        AddCurves(record, shapes);
    }

    public void AddText(PlacedText text) => block.Texts.Add(text);

    public void AddConstant(EntityRecord record, PlacedText text)
    {
        Count(record.Type, 1);
        AddText(text);
    }

    public void AddPoint(PlacedPoint point) => block.Points.Add(point);

    public void Note(in RecordIssue oddity) => block.Issues.Add(oddity);

    public void AddInsert(EntityRecord record, in BlockInsert insert, int attributes)
    {
        block.Inserts.Add(new NestedInsert(insert, columns.Count));
        if (attributes > 0) Count("ATTRIB", attributes);
    }

    public void AddConstruction(EntityRecord record)
    {
        if (record.Kind is RecordKind.Text or RecordKind.Point or RecordKind.Attribute) Count(record.Type, 1);
        if (!ConstructionTally.Counts(record, inBlock: true)) return;
        var known = block.Construction.GetValueOrDefault((record.Type, record.Layer), (0, ConstructionTally.SourceOf(record)));
        block.Construction[(record.Type, record.Layer)] = (known.Item1 + 1, known.Item2);
    }

    public void Refuse(EntityRecord record, in RecordIssue issue)
    {
        block.Issues.Add(issue);
        if (issue.ConcernsMore) balance.AddInBlock(issue);
    }

    private void Count(string type, int count) => block.Annotations[type] = block.Annotations.GetValueOrDefault(type) + count;
}
