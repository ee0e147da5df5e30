using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Reports;

/// <summary>Text report of the contents of a drawing.</summary>
public static class DrawingText
{
    public static void Write(TextWriter output, Drawing drawing, DrawingSummary summary)
    {
        if (IsUnusable(drawing))
        {
            output.WriteLine(Wording.Get("DrawingText.Head", drawing.FileName, List(Bytes(drawing), Wording.Get("DrawingText.NothingRead"))));
            return;
        }

        var balance = drawing.Balance;
        output.WriteLine(Wording.Get("DrawingText.Head", drawing.FileName, List(Version(drawing), Bytes(drawing), Unit(drawing.Unit))));
        output.WriteLine(Wording.Get("DrawingText.Balance", CountText.Format(balance.Read, "Entity"), balance.Cut, balance.Construction, balance.Refused.Count, balance.EntityCounts.Count == 0 ? "" : $" ({Counts(balance.EntityCounts)})"));
        if (summary.Leaf.Count > 0) output.WriteLine(Wording.Get("DrawingText.Curves", Counts(summary.Leaf.ToDictionary(pair => pair.Key.ToDxfName(), pair => pair.Value)), summary.Length.Total, drawing.Unit.Name));
        output.WriteLine(Size(summary.Bounds, drawing.Unit));
        if (!drawing.Placement.IsNone) output.WriteLine(Wording.Get("DrawingText.Placed", PlacementText.Of(drawing.Placement)));
        foreach (var (layer, index) in drawing.Layers.Select((layer, index) => (layer, index)))
        {
            var switches = List(layer.On ? "" : Wording.Get("DrawingText.Off"), layer.Frozen ? Wording.Get("DrawingText.Frozen") : "", layer.Plot ? "" : Wording.Get("DrawingText.NotPlotted"));
            output.WriteLine(Wording.Get("DrawingText.Layer", layer.Name, List(CountText.Format(Records(balance, index), "Entity"), switches)));
        }

        foreach (var refused in balance.Refused.Concat(balance.RefusedInBlocks))
        {
            output.WriteLine(Wording.Get("DrawingText.NotRead", $"{refused.Type} {refused.Handle}".TrimEnd(), refused.Line, refused.Reason, refused.DiagnosticId));
        }
    }

    /// <summary>True if nothing could be read: version and unit are unknown, and counts of 0 would suggest an empty drawing.</summary>
    private static bool IsUnusable(Drawing drawing) => drawing is { HasErrors: true, DxfVersion.Length: 0, Layers.Count: 0, Balance.Read: 0 };

    private static string Bytes(Drawing drawing) => drawing.Bytes == 0 ? "" : Wording.Get(drawing.Bytes == 1 ? "DrawingText.Bytes.One" : "DrawingText.Bytes.Many", drawing.Bytes);

    private static int Records(ReadBalance balance, int layer) => layer < balance.RecordsPerLayer.Count ? balance.RecordsPerLayer[layer] : 0;

    private static string Version(Drawing drawing) => drawing.DxfVersion.Length == 0 ? Wording.Get("DrawingText.Dxf", drawing.Encoding) : Wording.Get("DrawingText.DxfVersion", drawing.Encoding, drawing.DxfVersion);

    private static string Unit(LengthUnit unit) => unit.MillimetresPerUnit == 1.0
        ? Wording.Get("DrawingText.Unit", unit.Name, unit.Source)
        : Wording.Get("DrawingText.UnitInMillimetres", unit.Name, unit.Source, unit.MillimetresPerUnit);

    private static string Size(Bounds2D? bounds, LengthUnit unit) => bounds is { } box
        ? Wording.Get("DrawingText.Size", box.Width, box.Height, unit.Name, box.MinX, box.MinY, box.MaxX, box.MaxY)
        : Wording.Get("DrawingText.NoCurve");

    /// <summary>The non-empty parts, separated by commas.</summary>
    private static string List(params IEnumerable<string> parts) => string.Join(", ", parts.Where(part => part.Length > 0));

    private static string Counts(IReadOnlyDictionary<string, int> counts) => string.Join(", ", counts.OrderByDescending(pair => pair.Value).Select(pair => Invariant($"{pair.Value} {pair.Key}")));

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
