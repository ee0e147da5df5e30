using System.Collections.Immutable;
using System.Text.Json.Serialization;

namespace Engraver.Workbench.SerialTexts;

/// <summary><see cref="PlateValues"/> as JSON; members without a value are left out, and an object with other members is refused.</summary>
[JsonUnmappedMemberHandling(JsonUnmappedMemberHandling.Disallow)]
public sealed record PlateValuesJson
{
    public IReadOnlyDictionary<string, long>? Counters { get; init; }

    public DateTimeOffset? Date { get; init; }

    public CsvRow? Row { get; init; }

    public int? Copy { get; init; }

    public static PlateValuesJson From(PlateValues values)
    {
        ArgumentNullException.ThrowIfNull(values);
        return new PlateValuesJson
        {
            Counters = values.Counters.IsEmpty ? null : values.Counters,
            Date = values.Date,
            Row = values.Row,
            Copy = values.Copy,
        };
    }

    /// <exception cref="ArgumentException">A counter is named twice.</exception>
    public PlateValues ToValues() => new()
    {
        Counters = (Counters ?? ImmutableDictionary<string, long>.Empty).ToImmutableSortedDictionary(StringComparer.OrdinalIgnoreCase),
        Date = Date,
        Row = Row,
        Copy = Copy,
    };
}

internal sealed record PlateJson(int Number, double X, double Y, PlateValuesJson Values, string? Fixture = null);

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull, RespectNullableAnnotations = true, RespectRequiredConstructorParameters = true)]
[JsonSerializable(typeof(PlateValuesJson))]
[JsonSerializable(typeof(PlateJson))]
internal sealed partial class SerialJsonContext : JsonSerializerContext;
