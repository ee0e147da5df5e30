using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;

namespace Engraver.Workbench.Settings;

/// <summary>The settings of a job as words, by the keys of the table of settings: how certificates, journals and the history of jobs keep them. The machine
/// profile is kept apart (<see cref="MachineProfileFile"/>).</summary>
public static class SettingValues
{
    /// <summary>Every setting that is not left to the drawing, by its key; numbers exact.</summary>
    public static IReadOnlyDictionary<string, string> Of(DrawingSettings settings)
    {
        var words = new SortedDictionary<string, string>(StringComparer.Ordinal);
        foreach (var setting in SettingTable.All)
        {
            if (setting.ToWord(settings) is { } word) words[setting.Key] = word;
        }

        return words;
    }

    /// <summary>The settings that were kept as these words. A missing setting has its default; an unknown key is ignored.</summary>
    /// <exception cref="FormatException">A word is not a value of its setting.</exception>
    public static DrawingSettings Read(IReadOnlyDictionary<string, string> words, MachineProfile machine)
    {
        ArgumentNullException.ThrowIfNull(words);
        return SettingTable.All.Aggregate(new DrawingSettings { Machine = machine }, (settings, setting) => words.TryGetValue(setting.Key, out var word) ? setting.FromWord(settings, word) : settings);
    }
}
