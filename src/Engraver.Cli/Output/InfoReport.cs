using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;

namespace Engraver.Cli.Output;

/// <summary>Collects the contents of a drawing for the JSON of <c>info</c>.</summary>
internal static class InfoReport
{
    /// <summary>Maximum number of texts in the report.</summary>
    private const int ShownTexts = 10_000;

    public static InfoJson Json(Drawing drawing, DrawingSummary summary, IReadOnlyList<Diagnostic> findings)
    {
        var balance = drawing.Balance;
        var length = summary.Length;
        var primitives = summary.Primitives;
        return new InfoJson(
            drawing.FileName,
            drawing.Bytes,
            drawing.DxfVersion,
            drawing.Encoding,
            new InfoJson.UnitsJson(drawing.Unit.Code, drawing.Unit.Name, drawing.Unit.Source, drawing.Unit.MillimetresPerUnit),
            balance.EntityCounts,
            new InfoJson.BalanceJson(balance.Read, balance.Cut, balance.Construction, Refused(balance.Refused), Refused(balance.RefusedInBlocks)),
            new InfoJson.PrimitivesJson(
                primitives.Line, primitives.Arc, primitives.Circle, primitives.Ellipse, primitives.Spline, primitives.Polyline, primitives.Point),
            summary.Leaf.ToDictionary(pair => pair.Key.ToDxfName(), pair => pair.Value),
            balance.TextCounts,
            new InfoJson.LengthJson(length.Line, length.Arc, length.Circle, length.Ellipse, length.Spline, length.Total, length.PlanTotal),
            summary.Bounds is { } box ? new InfoJson.BoundsJson(box.MinX, box.MinY, box.MaxX, box.MaxY) : null,
            [.. drawing.Layers.Select((layer, index) => new InfoJson.LayerJson(layer.Name, layer.On, layer.Frozen, layer.Plot, layer.Locked, Records(balance, index)))],
            [.. findings.Select(DiagnosticJson.From)],
            [.. drawing.Texts.Take(ShownTexts).Select(text => Text(text, drawing.Layers))]);
    }

    private static InfoJson.TextJson Text(PlacedText text, IReadOnlyList<Layer> layers) => new(
        text.Type, text.Content, text.Position.X, text.Position.Y, text.Height, text.Rotation.Degrees, text.WidthFactor, text.Mirrored, text.Column.ToString().ToLowerInvariant(), text.Row.ToString().ToLowerInvariant(),
        text.Style, text.Font, layers[text.Layer].Name, text.Hidden, text.Source.Handle, text.SourceLine);

    private static IReadOnlyList<InfoJson.RefusedJson> Refused(IReadOnlyList<RefusedEntity> entities) => [.. entities.Select(InfoJson.RefusedJson.From)];

    private static int Records(ReadBalance balance, int layer) => layer < balance.RecordsPerLayer.Count ? balance.RecordsPerLayer[layer] : 0;
}
