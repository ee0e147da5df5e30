using System.Diagnostics;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Dxf;

/// <summary>Writes entities as pairs, each in the form its DXF version prescribes (DXF Reference, "ENTITIES Section").</summary>
internal sealed class EntityWriter(TagStream tags)
{
    /// <param name="entity">What to write.</param>
    /// <param name="owner">Handle of the block record it belongs to.</param>
    public void Write(DxfEntity entity, string owner)
    {
        switch (entity)
        {
            case LineEntity line:
                Begin("LINE", line, owner).Subclass("AcDbLine").Point(10, line.From).Point(11, line.To);
                break;
            case CircleEntity circle:
                Begin("CIRCLE", circle, owner).Subclass("AcDbCircle").Point(10, circle.Centre).Real(40, circle.Radius);
                break;
            case ArcEntity arc:
                WriteArc(arc, owner);
                break;
            case PolylineEntity polyline when tags.IsR12:
                WriteHeavyPolyline(polyline, owner);
                break;
            case PolylineEntity polyline:
                WriteLightPolyline(polyline, owner);
                break;
            case InsertEntity insert:
                WriteInsert(insert, owner);
                break;
            case TextEntity text:
                WriteText(text, owner);
                break;
            default:
                throw new UnreachableException();
        }
    }

    private void WriteText(TextEntity text, string owner)
    {
        Begin("TEXT", text, owner).Subclass("AcDbText").Point(10, text.At).Real(40, text.Height).Text(1, text.Text);
        if (text.Style is { } style)
        {
            tags.Text(7, style);
        }

        if (text.Centred)
        {
            tags.Integer(72, 1).Point(11, text.At);
        }

        tags.Subclass("AcDbText");
    }

    private TagStream Begin(string type, DxfEntity entity, string owner) =>
        tags.Begin(type, owner).Subclass("AcDbEntity").Text(8, entity.Layer);

    private void WriteArc(ArcEntity arc, string owner) =>
        Begin("ARC", arc, owner).Subclass("AcDbCircle").Point(10, arc.Centre).Real(40, arc.Radius)
            .Subclass("AcDbArc").Real(50, WithinOneTurn(arc.Start)).Real(51, WithinOneTurn(arc.End));

    /// <remarks>Rounded before it is folded, so that a hair below zero becomes 0 and not 360.</remarks>
    private static double WithinOneTurn(double degrees)
    {
        var rounded = RealFormat.Trimmed.Round(degrees);
        return rounded < 0 ? rounded + 360 : rounded;
    }

    private void WriteHeavyPolyline(PolylineEntity polyline, string owner)
    {
        Begin("POLYLINE", polyline, owner).Integer(66, 1).Point(10, default).Integer(70, polyline.Closed ? 1 : 0);
        foreach (var vertex in polyline.Vertices)
        {
            WithBulge(Begin("VERTEX", polyline, owner).Point(10, vertex.At), vertex);
        }

        Begin("SEQEND", polyline, owner);
    }

    private void WriteLightPolyline(PolylineEntity polyline, string owner)
    {
        Begin("LWPOLYLINE", polyline, owner).Subclass("AcDbPolyline").Integer(90, polyline.Vertices.Count).Integer(70, polyline.Closed ? 1 : 0);
        foreach (var vertex in polyline.Vertices)
        {
            WithBulge(tags.Real(10, vertex.At.X).Real(20, vertex.At.Y), vertex);
        }
    }

    private static void WithBulge(TagStream written, Vertex vertex)
    {
        if (vertex.Bulge != 0)
        {
            written.Real(42, vertex.Bulge);
        }
    }

    private void WriteInsert(InsertEntity insert, string owner)
    {
        var isArray = insert.Columns > 1 || insert.Rows > 1;
        Begin("INSERT", insert, owner).Subclass(isArray ? "AcDbMInsertBlock" : "AcDbBlockReference").Text(2, insert.Block).Point(10, insert.At)
            .Real(41, insert.ScaleX).Real(42, insert.ScaleY).Real(43, 1).Real(50, insert.Rotation);
        if (isArray)
        {
            tags.Integer(70, insert.Columns).Integer(71, insert.Rows).Real(44, insert.Spacing).Real(45, insert.Spacing);
        }
    }
}
