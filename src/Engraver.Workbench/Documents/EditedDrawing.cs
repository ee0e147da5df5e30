using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing as it stands after edits, made ready to be written.</summary>
public static class EditedDrawing
{
    /// <summary>AutoCAD's white or black.</summary>
    private const int Foreground = 7;

    /// <summary>Every curve that is not hidden, in file order and direction, in millimetres on its layer. A layer that is not cut is written as one that is not plotted.</summary>
    /// <returns>Null when the drawing has ellipses or splines, which the writer cannot spell.</returns>
    public static DxfSheet? SheetOf(Drawing drawing)
    {
        var names = Names(drawing.Layers);
        var entities = new List<DxfSheetEntity>();
        for (var index = 0; index < drawing.Entities.Count; index++)
        {
            var entity = drawing.Entities[index];
            if (entity.Hidden) continue;
            for (var part = entity.FirstPart; part < entity.FirstPart + entity.PartCount; part++)
            {
                if (drawing.Parts[part].IsFreeCurve) return null;
                entities.Add(new DxfSheetEntity(InMillimetres(drawing.Parts[part].InPlan(), drawing.Unit.ToMillimetres), names[entity.Layer], null, 0, 0));
            }
        }

        var layers = drawing.Layers.Select((layer, i) => new DxfSheetLayer(names[i], Foreground, layer.CutByDefault)).Where(layer => layer.Name != "0");
        return new DxfSheet([.. layers], entities);
    }

    /// <summary>Letters, digits and underscores, each once: the names that every reader of AC1015 takes.</summary>
    private static string[] Names(IReadOnlyList<Layer> layers)
    {
        var taken = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
        var names = new string[layers.Count];
        for (var i = 0; i < names.Length; i++)
        {
            var plain = string.Concat(layers[i].Name.Select(letter => char.IsAsciiLetterOrDigit(letter) ? letter : '_'));
            var name = plain.Length == 0 ? "_" : plain;
            for (var number = 2; !taken.Add(name); number++) name = FormattableString.Invariant($"{plain}_{number}");
            names[i] = name;
        }

        return names;
    }

    private static Segment InMillimetres(in Segment segment, double scale) => segment.Kind == SegmentKind.Line
        ? Segment.FromLine(Scaled(segment.Start, scale), Scaled(segment.End, scale))
        : Segment.FromArc(new ArcSegment(Scaled(segment.Arc.Centre, scale), segment.Arc.Radius * scale, segment.Arc.Start, segment.Arc.Sweep));

    private static Point2D Scaled(Point2D point, double scale) => new(point.X * scale, point.Y * scale);
}
