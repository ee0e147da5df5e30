using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Blocks;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf;

/// <summary>Receives the records of a BLOCK or of model space.</summary>
internal interface IContentTarget
{
    /// <summary>False for records that the target ignores (paper space).</summary>
    bool Accepts(EntityRecord record);

    void AddCurve(EntityRecord record, CurveShape shape);

    /// <summary>Several curves of one record (the loops of a hatch boundary).</summary>
    void AddCurves(EntityRecord record, IReadOnlyList<CurveShape> shapes);

    /// <summary>Outlines of construction that only operations may take.</summary>
    void AddAreas(EntityRecord record, IReadOnlyList<CurveShape> shapes);

    void AddInsert(EntityRecord record, in BlockInsert insert, int attributes);

    /// <summary>A text, point, dimension or other construction: drawn, not cut.</summary>
    void AddConstruction(EntityRecord record);

    /// <summary>The content of a text that has already been counted.</summary>
    void AddText(PlacedText text);

    /// <summary>A constant attribute, which every copy of its block shows. In model space, where it is a template, it is ignored.</summary>
    void AddConstant(EntityRecord record, PlacedText text);

    /// <summary>The position of a point that has already been counted.</summary>
    void AddPoint(PlacedPoint point);

    /// <summary>A finding about a record that was accepted.</summary>
    void Note(in RecordIssue oddity);

    /// <summary>A record that should have given a curve but did not.</summary>
    void Refuse(EntityRecord record, in RecordIssue issue);
}
