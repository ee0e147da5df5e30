using System.Globalization;
using System.Text.Json;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.SerialTexts;

/// <summary>One plate of a run.</summary>
/// <param name="Number">In its run, from 1.</param>
/// <param name="Offset">Of its cell on the blank, millimetres; zero without a grid.</param>
public sealed record Plate(int Number, PlateValues Values, Vector2D Offset)
{
    /// <summary>Name of the work origin at which it is engraved; null: the active one.</summary>
    public string? Fixture { get; init; }

    /// <summary>One line for people and for searches, the same in every language.</summary>
    public override string ToString()
    {
        var cell = Offset == default ? "" : string.Create(CultureInfo.InvariantCulture, $" at {Offset.X:0.###},{Offset.Y:0.###}");
        return (Values + cell + (Fixture is null ? "" : $" in {Fixture}")).TrimStart();
    }

    /// <summary>For the journal: <see cref="FromJson"/> returns the same plate.</summary>
    public string ToJson() => JsonSerializer.Serialize(new PlateJson(Number, Offset.X, Offset.Y, PlateValuesJson.From(Values), Fixture), SerialJsonContext.Default.PlateJson);

    /// <exception cref="FormatException">The text is not such a record.</exception>
    public static Plate FromJson(string text)
    {
        try
        {
            var read = JsonSerializer.Deserialize(text, SerialJsonContext.Default.PlateJson) ?? throw new FormatException(Wording.Get("Serial.InvalidRecord"));
            return new Plate(read.Number, read.Values.ToValues(), new Vector2D(read.X, read.Y)) { Fixture = read.Fixture };
        }
        catch (Exception invalid) when (invalid is JsonException or ArgumentException)
        {
            throw new FormatException(Wording.Get("Serial.InvalidRecord"), invalid);
        }
    }
}
