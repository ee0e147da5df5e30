using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing as it stands after edits, made ready to be written.</summary>
public static class EditedDrawing
{
    private const int Foreground = 7;

    /// <summary>$INSUNITS of a drawing that was read as millimetres because it did not say.</summary>
    private const int Millimetres = 4;

    /// <summary>Every curve in file order and direction, in the drawing's unit, with its layers and colours as they are. Heights are left out.</summary>
    /// <param name="hiddenObjects">What the operator hid for the moment: written as visible. All else that is invisible is written so.</param>
    public static DxfSheet SheetOf(Drawing drawing, IReadOnlyList<int> hiddenObjects)
    {
        var shown = hiddenObjects.ToHashSet();
        var entities = new List<DxfSheetEntity>(drawing.Entities.Count);
        for (var index = 0; index < drawing.Entities.Count; index++) entities.AddRange(Written(drawing, index, drawing.Entities[index].Hidden && !shown.Contains(index)));
        return new DxfSheet([.. drawing.Layers.Select(LayerOf)], entities) { InsUnits = drawing.Unit.Code is > 0 and var code ? code : Millimetres };
    }

    private static DxfSheetLayer LayerOf(Layer layer) =>
        new(layer.Name, layer.Colour.Index ?? Foreground, layer.Plot) { On = layer.On, Frozen = layer.Frozen, Rgb = layer.Colour.Rgb };

    /// <summary>The entity, or its parts one by one where DXF has no polyline like it.</summary>
    private static IEnumerable<DxfSheetEntity> Written(Drawing drawing, int index, bool hidden)
    {
        var entity = drawing.Entities[index];
        Segment[] segments = [.. Enumerable.Range(entity.FirstPart, entity.PartCount).Select(part => drawing.SegmentOf(drawing.Parts[part]))];
        if (entity.Type is CurveType.LwPolyline or CurveType.Polyline && DxfPolylineWriter.CanWrite(segments, entity.Closed)) return [Made(segments[0]) with { Run = segments, Closed = entity.Closed }];
        return segments.Select(Made);

        DxfSheetEntity Made(Segment segment) => new(segment, drawing.Layers[entity.Layer].Name, null, 0, 0) { Colour = entity.Colour, Hidden = hidden };
    }
}
