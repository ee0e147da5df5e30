using System.Text.Json;
using System.Text.Json.Nodes;
using Engraver.Core.Operations;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>Edits of a list of operations, as edits of its text: what a file may say can be entered, and is checked as a file is.</summary>
public static class OperationEdits
{
    private static readonly JsonSerializerOptions s_plain = new() { Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping };
    private static readonly JsonSerializerOptions s_indented = new(s_plain) { WriteIndented = true };

    /// <summary>The plan as a file for people.</summary>
    public static string ToFile(OperationPlan plan)
    {
        ArgumentNullException.ThrowIfNull(plan);
        return JsonNode.Parse(plan.ToFileText())!.ToJsonString(s_indented) + "\n";
    }

    /// <summary>The fields that an operation may have, with the values that it states.</summary>
    public static IReadOnlyList<OperationField> FieldsOf(OperationPlan plan, Operation operation)
    {
        ArgumentNullException.ThrowIfNull(plan);
        ArgumentNullException.ThrowIfNull(operation);
        var stated = Find(FileOf(plan), operation.Id);
        return [.. OperationFile.FieldsOf(operation.Kind).Where(field => field != "id").Select(field => (Field: field, Choices: OperationFile.ChoicesOf(field))).Select(one => new OperationField(one.Field, stated[one.Field] is { } value ? TextOf(value) : one.Choices is [var missing, ..] ? missing : "", one.Choices))];
    }

    /// <summary>Appends an operation.</summary>
    /// <param name="plan">Null for none yet.</param>
    /// <param name="tool">The tool, if the plan does not have it yet; otherwise null.</param>
    /// <exception cref="SettingException">The operation is not valid; the message states why.</exception>
    public static OperationPlan Added(OperationPlan? plan, JsonObject operation, JsonObject? tool)
    {
        var file = plan is null ? new JsonObject { ["version"] = OperationFile.Version, ["tools"] = new JsonArray(), ["operations"] = new JsonArray() } : FileOf(plan);
        if (tool is not null) file["tools"]!.AsArray().Add(tool);
        file["operations"]!.AsArray().Add(operation);
        return Read(file);
    }

    /// <summary>Sets a field of an operation.</summary>
    /// <param name="value">As in the file; a text needs no quotes, and outputs may be separated by commas. Empty removes the field.</param>
    /// <exception cref="SettingException">The value is not valid.</exception>
    public static OperationPlan Changed(OperationPlan plan, string id, string field, string value)
    {
        var file = FileOf(plan);
        var operation = Find(file, id);
        if (value.Length == 0) operation.Remove(field);
        else operation[field] = NodeOf(value) switch { JsonValue when field == OperationFile.OutputsField => new JsonArray([.. value.Split(',').Select(name => (JsonNode)name.Trim())]), var node => node };
        return Read(file);
    }

    /// <summary>Sets a field of an object in an operation.</summary>
    /// <param name="value">Null removes the field, and the object when it is then empty.</param>
    /// <exception cref="SettingException">The value is not valid.</exception>
    public static OperationPlan Changed(OperationPlan plan, string id, string field, string inner, JsonNode? value)
    {
        var file = FileOf(plan);
        var operation = Find(file, id);
        var edited = operation[field]?.AsObject() ?? [];
        if (value is null) edited.Remove(inner);
        else edited[inner] = value;
        operation.Remove(field);
        if (edited.Count > 0) operation[field] = edited;
        return Read(file);
    }

    /// <exception cref="SettingException">No operation would be left.</exception>
    public static OperationPlan Deleted(OperationPlan plan, string id)
    {
        var file = FileOf(plan);
        file["operations"]!.AsArray().Remove(Find(file, id));
        return Read(file);
    }

    /// <param name="position">From 1.</param>
    public static OperationPlan Moved(OperationPlan plan, string id, int position)
    {
        var file = FileOf(plan);
        var (list, operation) = (file["operations"]!.AsArray(), Find(file, id));
        list.Remove(operation);
        list.Insert(Math.Clamp(position - 1, 0, list.Count), operation);
        return Read(file);
    }

    private static JsonObject FileOf(OperationPlan plan) => JsonNode.Parse(plan.ToFileText())!.AsObject();

    private static JsonObject Find(JsonObject file, string id) => file["operations"]!.AsArray().Select(node => node!.AsObject()).First(one => (string?)one["id"] == id);

    private static OperationPlan Read(JsonObject file)
    {
        var read = OperationFile.Read(file.ToJsonString(), name => (null, name));
        return read.Plan ?? throw new SettingException(string.Join(' ', read.Diagnostics.Select(finding => finding.Message)));
    }

    /// <summary>The text that <see cref="NodeOf"/> reads as this value.</summary>
    private static string TextOf(JsonNode value) => value.GetValueKind() == JsonValueKind.String ? value.GetValue<string>() : value.ToJsonString(s_plain);

    /// <summary>Numbers, lists and objects as JSON; everything else is a text.</summary>
    private static JsonNode? NodeOf(string value)
    {
        try
        {
            return JsonNode.Parse(value);
        }
        catch (JsonException)
        {
            return JsonValue.Create(value);
        }
    }
}
