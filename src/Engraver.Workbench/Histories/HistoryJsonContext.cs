using System.Text.Json.Serialization;

namespace Engraver.Workbench.Histories;

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, NewLine = "\n", RespectNullableAnnotations = true)]
[JsonSerializable(typeof(HistoryEntry))]
[JsonSerializable(typeof(HistoryVersion))]
internal sealed partial class HistoryJsonContext : JsonSerializerContext;
