using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>Writes a plan as the text of an operations file, in one line: journals, certificates and histories keep it.</summary>
internal static class OperationText
{
    /// <summary>Every operation, and the tools.</summary>
    /// <param name="withAllTools">False: only the tools that an operation names.</param>
    public static string Write(OperationPlan plan, bool withAllTools)
    {
        using var memory = new MemoryStream();
        using (var writer = new Utf8JsonWriter(memory, new JsonWriterOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping }))
        {
            writer.WriteStartObject();
            writer.WriteString("version", OperationFile.Version);
            writer.WriteStartArray("tools");
            foreach (var tool in plan.Tools.Where(tool => withAllTools || plan.Operations.Any(operation => operation.Tool == tool.Number))) Write(writer, tool);
            writer.WriteEndArray();
            writer.WriteStartArray("operations");
            foreach (var operation in plan.Operations) Write(writer, operation);
            writer.WriteEndArray();
            writer.WriteEndObject();
        }

        return Encoding.UTF8.GetString(memory.ToArray());
    }

    private static void Write(Utf8JsonWriter writer, CuttingTool tool)
    {
        writer.WriteStartObject();
        writer.WriteNumber("number", tool.Number);
        if (tool.Name.Length > 0) writer.WriteString("name", tool.Name);
        writer.WriteString("kind", OperationFields.WordOf(tool.Kind));
        writer.WriteNumber("diameter", tool.Diameter);
        WriteNumber(writer, "angle", tool.AngleDegrees);
        WriteNumber(writer, "tip", tool.Tip == 0.0 ? null : tool.Tip);
        WriteNumber(writer, "flutes", tool.Flutes);
        WriteNumber(writer, "maxDepth", tool.MaxDepth);
        WriteNumber(writer, "feed", tool.Feed);
        WriteNumber(writer, "plunge", tool.Plunge);
        WriteNumber(writer, "spindle", tool.Spindle);
        writer.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter writer, Operation operation)
    {
        writer.WriteStartObject();
        writer.WriteString("id", operation.Id);
        if (operation.Name.Length > 0) writer.WriteString("name", operation.Name);
        if (!operation.IsOn) writer.WriteBoolean("on", false);
        writer.WriteString("kind", operation.KindWord);
        Write(writer, operation.Select);
        writer.WriteNumber("tool", operation.Tool);
        WriteNumber(writer, "feed", operation.Feed);
        WriteNumber(writer, "plunge", operation.Plunge);
        WriteNumber(writer, "spindle", operation.Spindle);
        WriteNumber(writer, "power", operation.Power);
        WriteNumber(writer, "startDepth", operation.StartDepth == 0.0 ? null : operation.StartDepth);
        if (operation.DepthByWidth) writer.WriteString("depth", OperationFile.LineWidth);
        WriteNumber(writer, "depth", operation.Depth);
        WriteNumber(writer, "depthPerPass", operation.DepthPerPass);
        WriteNumber(writer, "finish", operation.Finish == 0.0 ? null : operation.Finish);
        WriteNumber(writer, "stock", operation.Stock == 0.0 ? null : operation.Stock);
        WriteNumber(writer, "repeats", operation.Repeats == 1 ? null : operation.Repeats);
        if (operation.StopsBetween) writer.WriteBoolean("stopBetween", true);
        Write(writer, OperationFile.OutputsField, operation.Outputs);
        if (operation.Direction != CutDirection.Any) writer.WriteString("direction", OperationFields.WordOf(operation.Direction));
        if (operation.Order != PassOrder.Contour) writer.WriteString("order", OperationFields.WordOf(operation.Order));
        if (operation.Kind == OperationKind.Profile) writer.WriteString("side", OperationFields.WordOf(operation.Side));
        if (operation.CutsDashes) writer.WriteBoolean("dashes", true);
        if (operation.TakesHatches) writer.WriteBoolean("hatches", true);
        if (operation.Kind == OperationKind.Pocket) WritePocket(writer, operation);
        if (operation.Kind == OperationKind.Fill) WriteFill(writer, operation);
        Write(writer, "leadIn", operation.LeadIn);
        Write(writer, "leadOut", operation.LeadOut);
        WriteNumber(writer, "overcut", operation.Overcut == 0.0 ? null : operation.Overcut);
        WriteRamp(writer, operation);
        WriteStart(writer, operation);
        if (operation.Tabs is { } tabs) Write(writer, tabs);
        WriteNumber(writer, "peck", operation.Peck);
        WriteNumber(writer, "maxDiameter", operation.MaxDiameter);
        WriteNumber(writer, "dwell", operation.DwellSeconds == 0.0 ? null : operation.DwellSeconds);
        WriteNumber(writer, "pierce", operation.PierceSeconds == 0.0 ? null : operation.PierceSeconds);
        writer.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter writer, string name, LeadMove? lead)
    {
        if (lead is null) return;
        writer.WriteStartObject(name);
        writer.WriteString("shape", OperationFields.WordOf(lead.Shape));
        writer.WriteNumber(lead.Shape == LeadShape.Arc ? "radius" : "length", lead.Length);
        if (lead.Direction != LeadDirection.Perpendicular) writer.WriteString("direction", OperationFields.WordOf(lead.Direction));
        writer.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter writer, PartTabs tabs)
    {
        writer.WriteStartObject("tabs");
        WriteNumber(writer, "count", tabs.Count);
        WriteNumber(writer, "spacing", tabs.Spacing);
        if (tabs is { At.Count: 0, Count: null, Spacing: null }) WriteEmpty(writer);
        Write(writer, tabs.At, tabs.Within);
        writer.WriteNumber("width", tabs.Width);
        WriteNumber(writer, "height", tabs.Height);
        if (tabs.Shape != TabShape.Square) writer.WriteString("shape", OperationFields.WordOf(tabs.Shape));
        WriteNumber(writer, "angle", tabs.AngleDegrees == PartTabs.UsualAngle ? null : tabs.AngleDegrees);
        writer.WriteEndObject();
    }

    private static void WriteRamp(Utf8JsonWriter writer, Operation operation)
    {
        if (operation.RampDegrees is not { } angle) return;
        writer.WriteStartObject("ramp");
        writer.WriteNumber("angle", angle);
        WriteNumber(writer, "radius", operation.HelixRadius);
        writer.WriteEndObject();
    }

    /// <summary>Tabs by hand of which none is left.</summary>
    private static void WriteEmpty(Utf8JsonWriter writer)
    {
        writer.WriteStartArray("at");
        writer.WriteEndArray();
    }

    private static void WriteStart(Utf8JsonWriter writer, Operation operation)
    {
        if (operation.Start == StartRule.Nearest && operation.StartAt.Count == 0) return;
        writer.WriteStartObject("start");
        if (operation.Start != StartRule.Nearest) writer.WriteString("rule", OperationFields.WordOf(operation.Start));
        Write(writer, operation.StartAt, operation.StartWithin);
        writer.WriteEndObject();
    }

    /// <summary>Picked places, and how far they may be from their contours.</summary>
    private static void Write(Utf8JsonWriter writer, IReadOnlyList<Point2D> at, double within)
    {
        if (at.Count == 0) return;
        writer.WriteStartArray("at");
        foreach (var place in at)
        {
            writer.WriteStartArray();
            writer.WriteNumberValue(place.X);
            writer.WriteNumberValue(place.Y);
            writer.WriteEndArray();
        }

        writer.WriteEndArray();
        WriteNumber(writer, "within", within == Operation.PickedWithin ? null : within);
    }

    private static void WriteFill(Utf8JsonWriter writer, Operation operation)
    {
        writer.WriteNumber("spacing", operation.Spacing);
        if (operation.Pattern != FillPattern.Lines) writer.WriteString("pattern", OperationFields.WordOf(operation.Pattern));
        if (operation.Pattern == FillPattern.Lines) writer.WriteBoolean("cross", operation.IsCross);
        if (operation.Pattern == FillPattern.Lines) writer.WriteNumber("angle", operation.AngleDegrees);
        WriteNumber(writer, "inset", operation.Inset);
        WriteNumber(writer, "overscan", operation.Overscan == 0.0 ? null : operation.Overscan);
    }

    private static void WritePocket(Utf8JsonWriter writer, Operation operation)
    {
        writer.WriteNumber("stepover", operation.Stepover);
        writer.WriteBoolean("zigzag", operation.IsZigzag);
        writer.WriteNumber("angle", operation.AngleDegrees);
    }

    private static void Write(Utf8JsonWriter writer, OperationSelection selection)
    {
        if (selection.IsRest)
        {
            writer.WriteString("select", "rest");
            return;
        }

        writer.WriteStartObject("select");
        foreach (var (name, texts) in ((string, IReadOnlyList<string>)[])[("layers", selection.Layers), ("colours", selection.Colours), ("linetypes", selection.Linetypes), ("blocks", selection.Blocks), ("handles", selection.Handles)])
        {
            Write(writer, name, texts);
        }

        writer.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter writer, string name, IReadOnlyList<string> texts)
    {
        if (texts.Count == 0) return;
        writer.WriteStartArray(name);
        foreach (var text in texts) writer.WriteStringValue(text);
        writer.WriteEndArray();
    }

    private static void WriteNumber(Utf8JsonWriter writer, string name, double? value)
    {
        if (value is { } number) writer.WriteNumber(name, number);
    }
}
