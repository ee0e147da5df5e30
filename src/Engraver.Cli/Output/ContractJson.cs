using System.Text.Json;
using System.Text.Json.Serialization;
using System.Text.Json.Serialization.Metadata;
using Engraver.Cli.Output.Jobs;

namespace Engraver.Cli.Output;

/// <summary>The JSON of the runner: UTF-8, camelCase, one object, numbers with a point. Generated at build time so that a small verb starts fast.</summary>
[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, NewLine = "\n", GenerationMode = JsonSourceGenerationMode.Metadata)]
[JsonSerializable(typeof(InfoJson))]
[JsonSerializable(typeof(SequenceJson))]
[JsonSerializable(typeof(PlanJson))]
[JsonSerializable(typeof(OffsetJson))]
[JsonSerializable(typeof(PocketJson))]
[JsonSerializable(typeof(PostJson))]
[JsonSerializable(typeof(RunJson))]
[JsonSerializable(typeof(TrajectoryListJson))]
[JsonSerializable(typeof(VerifyJson))]
[JsonSerializable(typeof(StatusJson))]
[JsonSerializable(typeof(DiscoverJson))]
[JsonSerializable(typeof(CertificateCheckJson))]
[JsonSerializable(typeof(HistoryListJson))]
[JsonSerializable(typeof(CounterListJson))]
[JsonSerializable(typeof(ReplayJson))]
internal sealed partial class ContractJson : JsonSerializerContext
{
    public static void Write<T>(TextWriter output, T value, JsonTypeInfo<T> type) => output.WriteLine(JsonSerializer.Serialize(value, type));
}
