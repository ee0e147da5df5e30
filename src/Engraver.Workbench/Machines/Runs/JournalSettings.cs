using System.Collections.Frozen;
using System.Text.Json;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The settings and the machine profile of a job as text values in its journal. A resumed run must have the same values, otherwise the parts of the
/// work would be cut differently.</summary>
internal static class JournalSettings
{
    /// <summary>Before the name of a font, as the drawing requests it.</summary>
    private const string Font = "font ";

    /// <summary>Fields of the profile that do not affect the cut.</summary>
    private static readonly FrozenSet<string> s_ignoredFields = FrozenSet.Create(StringComparer.Ordinal, "costPerHour", "costPerMetre", "costPerStart", "inputs", "outputs", "jogMmPerMinute", "travelX", "travelY", "travelZ");

    /// <summary>A longer value is shown by its hash: the operations.</summary>
    private const int LongestShown = 160;

    private const int ShownDigits = 12;

    /// <summary>Key of the plate, which is not a setting.</summary>
    public const string PlateKey = "plate";

    /// <summary>Values by the keys of docs/settings.md and the fields of docs/machine-profile.md; the font that is cut by <c>font NAME</c>.</summary>
    public static IReadOnlyDictionary<string, string> Of(PreparedJob job)
    {
        var settings = job.Recorded;
        var words = new SortedDictionary<string, string>(StringComparer.Ordinal);
        foreach (var (key, word) in SettingValues.Of(settings)) words[key] = word;
        using var profile = JsonDocument.Parse(MachineProfileFile.Write(settings.Machine));
        foreach (var field in profile.RootElement.EnumerateObject())
        {
            if (field.Value.ValueKind != JsonValueKind.Null && !s_ignoredFields.Contains(field.Name)) words[field.Name] = string.Concat(field.Value.ToString().Where(letter => !char.IsWhiteSpace(letter)));
        }

        if (job.Plate is { } plate) words[PlateKey] = plate.ToJson();
        foreach (var font in job.Fonts) words[Font + font.Requested] = $"{font.Font} ({font.Match}, SHA-256 {font.Sha256})";
        return words;
    }

    /// <summary>Why an interrupted job cannot be resumed by this one. Different settings are named instead of the different path.</summary>
    /// <returns>Null if it can.</returns>
    public static string? ResumeRefusal(ResumePosition found, PreparedJob job) =>
        (found.Refusal is null || found.IsPathChanged) && found.Settings is { } then && Difference(then, Of(job)) is { } other ? other : found.Refusal;

    /// <summary>All different settings with both values; null if there are none.</summary>
    private static string? Difference(IReadOnlyDictionary<string, string> then, IReadOnlyDictionary<string, string> now)
    {
        var keys = then.Keys.Union(now.Keys).Where(key => then.GetValueOrDefault(key) != now.GetValueOrDefault(key)).Order(StringComparer.Ordinal);
        var differing = keys.Select(key => Wording.Get("Resume.OtherSetting", Name(key), Value(key, then), Value(key, now))).ToList();
        return differing.Count == 0 ? null : Wording.Get("Resume.OtherSettings", string.Join("; ", differing));
    }

    private static Setting? Setting(string key) => SettingTable.Find(key) ?? SettingTable.All.FirstOrDefault(setting => setting.JsonField == key);

    private static string Name(string key) => key.StartsWith(Font, StringComparison.Ordinal) ? Wording.Get("Resume.Font", key[Font.Length..]) : Setting(key)?.Name ?? key;

    private static string Value(string key, IReadOnlyDictionary<string, string> words) =>
        words.GetValueOrDefault(key) is { } word ? word.Length > LongestShown ? Wording.Get("Resume.Hash", ContentHash.OfText(word)[..ShownDigits]) : $"{word} {Setting(key)?.Unit}".TrimEnd() : Wording.Get("Resume.NotSet");
}
