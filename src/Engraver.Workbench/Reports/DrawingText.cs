using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Reports;

/// <summary>What is in a drawing, for people.</summary>
public static class DrawingText
{
    public static void Write(TextWriter output, Drawing drawing, DrawingSummary summary)
    {
        if (IsUnusable(drawing))
        {
            output.WriteLine(Invariant($"{drawing.FileName}: {Bytes(drawing)}nothing could be read"));
            return;
        }

        var balance = drawing.Balance;
        output.WriteLine(Invariant($"{drawing.FileName}: {Version(drawing)}, {Bytes(drawing)}{Unit(drawing.Unit)}"));
        output.WriteLine(Invariant($"{CountText.Format(balance.Read, "entity")} read = {balance.Cut} cut + {balance.Construction} construction + {balance.Refused.Count} refused{(balance.EntityCounts.Count == 0 ? "" : $" ({Counts(balance.EntityCounts)})")}"));
        if (summary.Leaf.Count > 0) output.WriteLine(Invariant($"curves, blocks expanded: {Counts(summary.Leaf.ToDictionary(pair => pair.Key.ToDxfName(), pair => pair.Value))}; length {summary.Length.Total:0.######} {drawing.Unit.Name}"));
        output.WriteLine(Size(summary.Bounds, drawing.Unit));
        foreach (var (layer, index) in drawing.Layers.Select((layer, index) => (layer, index)))
        {
            var switches = $"{(layer.On ? "" : ", off")}{(layer.Frozen ? ", frozen" : "")}{(layer.Plot ? "" : ", not plotted")}";
            output.WriteLine(Invariant($"  layer {layer.Name}: {CountText.Format(Records(balance, index), "entity")}{switches}"));
        }

        foreach (var refused in balance.Refused.Concat(balance.RefusedInBlocks))
        {
            output.WriteLine(Invariant($"  not read: {refused.Type}{(refused.Handle is { } handle ? $" {handle}" : "")} at line {refused.Line}: {refused.Reason} ({refused.DiagnosticId})"));
        }
    }

    /// <summary>Neither its version nor its unit is known then, and to count nothing would say that it was looked at.</summary>
    private static bool IsUnusable(Drawing drawing) => drawing is { HasErrors: true, DxfVersion.Length: 0, Layers.Count: 0, Balance.Read: 0 };

    private static string Bytes(Drawing drawing) => drawing.Bytes == 0 ? "" : Invariant($"{drawing.Bytes} {(drawing.Bytes == 1 ? "byte" : "bytes")}, ");

    private static int Records(DrawingBalance balance, int layer) => layer < balance.RecordsPerLayer.Count ? balance.RecordsPerLayer[layer] : 0;

    private static string Version(Drawing drawing) => drawing.DxfVersion.Length == 0 ? $"{drawing.Encoding} DXF" : $"{drawing.Encoding} DXF {drawing.DxfVersion}";

    private static string Unit(LengthUnit unit) => Invariant($"unit {unit.Name} ({unit.Source}{(unit.ToMillimetres == 1.0 ? "" : Invariant($", {unit.ToMillimetres:0.######} mm"))})");

    private static string Size(Bounds2D? bounds, LengthUnit unit) => bounds is { } box
        ? Invariant($"size {box.Width:0.######} x {box.Height:0.######} {unit.Name}, from {box.MinX:0.######},{box.MinY:0.######} to {box.MaxX:0.######},{box.MaxY:0.######}")
        : "no curve";

    private static string Counts(IReadOnlyDictionary<string, int> counts) => string.Join(", ", counts.OrderByDescending(pair => pair.Value).Select(pair => Invariant($"{pair.Value} {pair.Key}")));

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
