using System.Text.Json;
using System.Text.Json.Serialization;

namespace Engraver.Galil.Profiles;

/// <summary>Reads and writes profile files without reflection.</summary>
[JsonSourceGenerationOptions(
    PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase,
    WriteIndented = true,
    AllowTrailingCommas = true,
    ReadCommentHandling = JsonCommentHandling.Skip,
    UnmappedMemberHandling = JsonUnmappedMemberHandling.Disallow,
    AllowDuplicateProperties = false)]
[JsonSerializable(typeof(MachineProfileDocument))]
internal sealed partial class MachineProfileJson : JsonSerializerContext;
