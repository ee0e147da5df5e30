using System.Text.Json.Serialization;

namespace Engraver.Galil.Jobs;

/// <summary>The lines of the journal.</summary>
[JsonSourceGenerationOptions(GenerationMode = JsonSourceGenerationMode.Metadata)]
[JsonSerializable(typeof(JournalHeader))]
[JsonSerializable(typeof(JournalProgress))]
[JsonSerializable(typeof(JournalEnd))]
[JsonSerializable(typeof(JournalFound))]
[JsonSerializable(typeof(JournalGivenBack))]
internal sealed partial class JournalJson : JsonSerializerContext;
