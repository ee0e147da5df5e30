using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Documents;

/// <summary>Converts an edited drawing to a DXF sheet for writing.</summary>
public static class EditedDrawing
{
    private const int Foreground = 7;

    /// <summary>$INSUNITS of a drawing that was read as millimetres because it has no unit.</summary>
    private const int Millimetres = 4;

    /// <summary>$INSUNITS of a drawing that was read as inches because it has no unit.</summary>
    private const int Inches = 1;

    /// <summary>Every curve in file order and direction, in the drawing's unit, with its heights, layers and colours; followed by the texts and points in file
    /// order.</summary>
    /// <param name="hiddenObjects">Objects hidden temporarily by the operator: written as visible. Other invisible objects stay invisible.</param>
    public static DxfSheet SheetOf(Drawing drawing, IReadOnlyList<int> hiddenObjects)
    {
        var shown = hiddenObjects.ToHashSet();
        var entities = new List<DxfSheetEntity>(drawing.Entities.Count);
        for (var index = 0; index < drawing.Entities.Count; index++) entities.AddRange(Written(drawing, index, drawing.Entities[index].Hidden && !shown.Contains(index)));
        return new DxfSheet([.. drawing.Layers.Select(layer => LayerOf(drawing, layer))], entities)
        {
            InsUnits = drawing.Unit.Code is > 0 and var code ? code : drawing.Unit == LengthUnit.AssumedInches ? Inches : Millimetres,
            Texts = [.. drawing.Texts.Select(text => new DxfSheetText(text with { Lineweight = WeightIn(drawing, text.Lineweight) }, drawing.Layers[text.Layer].Name))],
            TextStyles = drawing.Styles,
            Points = [.. drawing.Points.Select(point => new DxfSheetPoint(point, drawing.Layers[point.Layer].Name, NameOf(drawing, point.Linetype)))],
            Linetypes = [.. drawing.Linetypes.Skip(Linetype.Standard.Count)],
            LinetypeScale = drawing.LinetypeScale,
        };
    }

    /// <summary>Maps each handle of the drawing to the handles of its entities in a written sheet.</summary>
    /// <param name="sheet">Created by <see cref="SheetOf"/> from this drawing.</param>
    public static IReadOnlyDictionary<string, IReadOnlyList<string>> HandlesIn(DxfSheet sheet, Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(sheet);
        ArgumentNullException.ThrowIfNull(drawing);
        var (written, handles, next) = (sheet.EntityHandles, new Dictionary<string, IReadOnlyList<string>>(StringComparer.OrdinalIgnoreCase), 0);
        for (var index = 0; index < drawing.Entities.Count; index++)
        {
            var count = Written(drawing, index, hidden: false).Count();
            if (drawing.SourceOf(index).Handle is { } handle) handles[handle] = [.. handles.GetValueOrDefault(handle, []), .. written.Skip(next).Take(count)];
            next += count;
        }

        foreach (var (point, handle) in drawing.Points.Zip(sheet.PointHandles))
        {
            if (point.Handle == 0) continue;
            var read = point.Handle.ToString("X", System.Globalization.CultureInfo.InvariantCulture);
            handles[read] = [.. handles.GetValueOrDefault(read, []), handle];
        }

        return handles;
    }

    private static DxfSheetLayer LayerOf(Drawing drawing, Layer layer) =>
        new(layer.Name, layer.Colour.Index ?? Foreground, layer.Plot) { On = layer.On, Frozen = layer.Frozen, Locked = layer.Locked, Rgb = layer.Colour.Rgb, Linetype = drawing.Linetypes[layer.Linetype].Name, Lineweight = WeightIn(drawing, layer.Lineweight) };

    /// <summary>A default other than the usual one is written as its value, because DXF has no variable for it.</summary>
    private static int WeightIn(Drawing drawing, int lineweight) => lineweight == Lineweight.Default && drawing.DefaultLineweight != Lineweight.UsualDefault ? drawing.DefaultLineweight : lineweight;

    private static string? NameOf(Drawing drawing, int linetype) => linetype == Linetype.ByLayer ? null : drawing.Linetypes[linetype].Name;

    /// <summary>The entity, or its individual parts if DXF has no such polyline.</summary>
    private static IEnumerable<DxfSheetEntity> Written(Drawing drawing, int index, bool hidden)
    {
        var entity = drawing.Entities[index];
        var (style, inserts) = (drawing.LineStyles[entity.LineStyle], InsertsOf(drawing, entity.Insert));
        Segment[] segments = [.. Enumerable.Range(entity.FirstPart, entity.PartCount).Select(part => drawing.SegmentOf(drawing.Parts[part]))];
        var heights = Enumerable.Range(entity.FirstPart, entity.PartCount).Select(part => HeightsOf(drawing.Parts[part])).ToArray();
        if (entity.Type is not (CurveType.LwPolyline or CurveType.Polyline) || !DxfPolylineWriter.CanWrite(segments, entity.Closed)) return Enumerable.Range(0, segments.Length).Select(Made);
        var run = Made(0) with { Run = segments, Closed = entity.Closed, RunsThrough = style.RunsThrough, Width = style.Width };
        if (Array.TrueForAll(heights, height => height.Start == heights[0].Start && height.End == heights[0].Start)) return [run];
        var inSpace = Array.TrueForAll(segments, segment => segment.Kind == SegmentKind.Line);
        double[] vertices = [.. heights.Select(height => height.Start), .. entity.Closed ? [] : new[] { heights[^1].End }];
        return inSpace ? [run with { Heights = vertices }] : Enumerable.Range(0, segments.Length).Select(Made);

        DxfSheetEntity Made(int part) => new(segments[part], drawing.Layers[entity.Layer].Name, null, 0, 0)
        {
            Colour = entity.Colour,
            Linetype = NameOf(drawing, style.Linetype),
            LinetypeScale = style.Scale == 1.0 ? null : style.Scale,
            Lineweight = style.Lineweight == Lineweight.ByLayer ? null : WeightIn(drawing, style.Lineweight),
            Inserts = inserts,
            Hidden = hidden,
            Z = heights[part],
            Source = drawing.SourceOf(index),
        };
    }

    /// <summary>The inserts of an entity, the outermost first; null for none.</summary>
    private static List<DxfSheetInsert>? InsertsOf(Drawing drawing, int insert)
    {
        if (insert <= 0) return null;
        var inserts = new List<DxfSheetInsert>();
        for (var number = insert; number > 0; number = drawing.Inserts[number - 1].Around) inserts.Insert(0, new DxfSheetInsert(drawing.Blocks[drawing.BlockPaths[drawing.Inserts[number - 1].Path].Block], number, drawing.Inserts[number - 1].Position));
        return inserts;
    }

    private static (double Start, double End) HeightsOf(in DrawingPart part) => part.Kind == SegmentKind.Line ? (part.C, part.F) : part.IsFreeCurve ? default : (part.C, part.C);
}
