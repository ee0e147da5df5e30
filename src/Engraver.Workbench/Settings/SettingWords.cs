using System.Globalization;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Machines.Profiles;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Workbench.Settings;

/// <summary>The settings of a job as words, by the keys of the table of settings: how a certificate and the history of jobs keep them. The machine profile
/// is kept apart (<see cref="MachineProfileFile"/>).</summary>
public static class SettingWords
{
    /// <summary>Letters stay what they are: who shows them escapes them in its own way.</summary>
    private static readonly SettingWordsJson s_json = new(new JsonSerializerOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping });

    private static readonly int s_everyChoice = Enum.GetValues<CutChoice>().Aggregate(0, (all, one) => all | (int)one);

    /// <summary>Every setting that is not left to the drawing, by its key; numbers exact.</summary>
    public static IReadOnlyDictionary<string, string> Of(DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        var words = new SortedDictionary<string, string>(StringComparer.Ordinal)
        {
            [SettingTable.SkippedLayers.Key] = Names(settings.SkippedLayers),
            [SettingTable.Cut.Key] = Number((int)settings.Cut),
            [SettingTable.JoinTolerance.Key] = Number(settings.JoinToleranceMm),
            [SettingTable.MaxError.Key] = Number(settings.MaxErrorMm),
            [SettingTable.Start.Key] = Place(settings.Start),
            [SettingTable.Finish.Key] = Word(settings.Finish),
            [SettingTable.Order.Key] = Word(settings.Order),
            [SettingTable.KeepDuplicates.Key] = Switch(settings.KeepDuplicates),
            [SettingTable.RecoverArcs.Key] = Switch(settings.RecoverArcs),
            [SettingTable.Kerf.Key] = Word(settings.Kerf),
            [SettingTable.ToolDiameter.Key] = Number(settings.ToolDiameterMm),
        };
        if (settings.Layers is { } layers) words[SettingTable.Layers.Key] = Names(layers);
        if (settings.Unit is { } unit) words[SettingTable.Units.Key] = Number(unit.Code);
        if (settings.Enter is { } enter) words[SettingTable.Enter.Key] = enter is EnteringPlace.ByPoint { Point: var point } ? Place(point) : ((EnteringPlace.ByHandle)enter).Handle;
        return words;
    }

    /// <summary>The settings that were kept as these words; what is missing has its default, what is not known is left out.</summary>
    /// <exception cref="FormatException">A word is no value of its setting.</exception>
    public static DrawingSettings Read(IReadOnlyDictionary<string, string> words, MachineProfile machine)
    {
        ArgumentNullException.ThrowIfNull(words);
        var plain = new DrawingSettings { Machine = machine };
        string? Of(SettingDescription setting) => words.GetValueOrDefault(setting.Key);
        return plain with
        {
            Layers = Of(SettingTable.Layers) is { } layers ? NamesIn(layers) : null,
            SkippedLayers = Of(SettingTable.SkippedLayers) is { } skipped ? NamesIn(skipped) : plain.SkippedLayers,
            Unit = Of(SettingTable.Units) is { } unit ? LengthUnits.ChosenFrom(NumberIn(unit)) ?? throw new FormatException(unit) : null,
            Cut = Of(SettingTable.Cut) is { } cut ? ChoicesIn(cut) : plain.Cut,
            JoinToleranceMm = NumberIn(Of(SettingTable.JoinTolerance), plain.JoinToleranceMm, least: 0.0),
            MaxErrorMm = NumberIn(Of(SettingTable.MaxError), plain.MaxErrorMm, least: double.Epsilon),
            Start = Of(SettingTable.Start) is { } start ? PlaceIn(start) ?? throw new FormatException(start) : plain.Start,
            Finish = WordIn(Of(SettingTable.Finish), plain.Finish),
            Enter = Of(SettingTable.Enter) is not { } enter ? null : PlaceIn(enter) is { } point ? new EnteringPlace.ByPoint(point) : new EnteringPlace.ByHandle(enter),
            Order = WordIn(Of(SettingTable.Order), plain.Order),
            KeepDuplicates = Of(SettingTable.KeepDuplicates) == Switch(true),
            RecoverArcs = Of(SettingTable.RecoverArcs) == Switch(true),
            Kerf = WordIn(Of(SettingTable.Kerf), plain.Kerf),
            ToolDiameterMm = NumberIn(Of(SettingTable.ToolDiameter), plain.ToolDiameterMm, least: 0.0),
        };
    }

    /// <summary>A name of a layer may hold any letter, so that the names are a JSON list.</summary>
    private static string Names(IReadOnlyList<string> names) => JsonSerializer.Serialize(names, s_json.IReadOnlyListString);

    private static IReadOnlyList<string> NamesIn(string word)
    {
        try
        {
            return JsonSerializer.Deserialize(word, s_json.IReadOnlyListString) ?? throw new FormatException(word);
        }
        catch (JsonException broken)
        {
            throw new FormatException(word, broken);
        }
    }

    private static string Number(double value) => value.ToString("R", CultureInfo.InvariantCulture);

    private static double NumberIn(string? word, double otherwise, double least) => word is null ? otherwise : NumberIn(word) is var value && value >= least ? value : throw new FormatException(word);

    private static CutChoice ChoicesIn(string word) => NumberIn(word) is var value && value >= 0.0 && value <= s_everyChoice && value == Math.Floor(value) ? (CutChoice)(int)value : throw new FormatException(word);

    private static double NumberIn(string word) => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) && double.IsFinite(value) ? value : throw new FormatException(word);

    private static string Place(Point2D place) => $"{Number(place.X)},{Number(place.Y)}";

    private static Point2D? PlaceIn(string word) => word.Split(',') is [var x, var y] ? new Point2D(NumberIn(x), NumberIn(y)) : null;

    private static string Switch(bool on) => on ? "1" : "0";

    private static string Word<T>(T choice)
        where T : struct, Enum => choice.ToString().ToLowerInvariant();

    private static T WordIn<T>(string? word, T otherwise)
        where T : struct, Enum => word is null ? otherwise : Enum.TryParse<T>(word, ignoreCase: true, out var choice) && Enum.IsDefined(choice) ? choice : throw new FormatException(word);
}

[JsonSerializable(typeof(IReadOnlyList<string>))]
internal sealed partial class SettingWordsJson : JsonSerializerContext;
