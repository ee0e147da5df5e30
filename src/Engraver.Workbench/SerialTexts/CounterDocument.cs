using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The counter book in its file.</summary>
internal sealed record CounterDocument
{
    public const int CurrentVersion = 1;

    public int Version { get; init; } = CurrentVersion;

    /// <summary>The next number of each counter.</summary>
    public IReadOnlyList<CounterNumber> Counters { get; init; } = [];

    public IReadOnlyList<StartedPlate> Plates { get; init; } = [];

    /// <summary>The first 64 bits of SHA-256 over the other members.</summary>
    public string Sum { get; init; } = "";

    public string ToJson() => JsonSerializer.Serialize(this with { Sum = ChecksumOf(JsonSerializer.Serialize(this, CounterJson.Default.CounterDocument)) }, CounterJson.Default.CounterDocument);

    /// <exception cref="JsonException">It is not such a document.</exception>
    /// <exception cref="InvalidDataException">It was changed, or belongs to another version.</exception>
    public static CounterDocument Read(string text)
    {
        var document = JsonSerializer.Deserialize(text, CounterJson.Default.CounterDocument) ?? throw new JsonException(Wording.Get("Counters.ContainsNull"));
        if (document.Version != CurrentVersion) throw new InvalidDataException(Wording.Get("Counters.OtherVersion", document.Version));
        return document.Sum == ChecksumOf(text) ? document : throw new InvalidDataException(Wording.Get("Counters.ChecksumMismatch"));
    }

    public long? NextOf(string counter) => Counters.FirstOrDefault(one => IsSame(one.Name, counter))?.Next;

    public CounterDocument WithNext(string counter, long next) =>
        this with { Counters = [.. Counters.Where(one => !IsSame(one.Name, counter)).Append(new CounterNumber(counter, next)).OrderBy(one => one.Name, StringComparer.OrdinalIgnoreCase)] };

    /// <summary>Without the number of one counter in a plate; a plate without numbers is removed.</summary>
    public CounterDocument Without(string counter, long number) => this with
    {
        Plates = [.. Plates.Select(plate => plate.Has(counter, number) ? plate with { Numbers = plate.Numbers.Where(one => !IsSame(one.Key, counter)).ToDictionary() } : plate).Where(plate => plate.Numbers.Count > 0)],
    };

    public static bool IsSame(string counter, string other) => counter.Equals(other, StringComparison.OrdinalIgnoreCase);

    /// <summary>Covers every member except the checksum; whitespace is ignored.</summary>
    private static string ChecksumOf(string json)
    {
        var members = JsonNode.Parse(json)!.AsObject();
        members.Remove("sum");
        return ContentHash.OfText(members.ToJsonString())[..16];
    }
}

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, NewLine = "\n", RespectNullableAnnotations = true, RespectRequiredConstructorParameters = true)]
[JsonSerializable(typeof(CounterDocument))]
internal sealed partial class CounterJson : JsonSerializerContext;
