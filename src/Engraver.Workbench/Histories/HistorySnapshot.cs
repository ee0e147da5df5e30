using System.Globalization;

namespace Engraver.Workbench.Histories;

/// <summary>The contents of the index.</summary>
/// <param name="Entries">The newest first.</param>
/// <param name="Findings">A sentence for each invalid file.</param>
public sealed record HistorySnapshot(IReadOnlyList<HistoryEntry> Entries, IReadOnlyList<string> Findings)
{
    /// <summary>The entry with this name or number (1 is the newest); null if there is none.</summary>
    public HistoryEntry? Find(string word) =>
        Entries.FirstOrDefault(entry => entry.Id == word) ?? (int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number >= 1 && number <= Entries.Count ? Entries[number - 1] : null);

    /// <summary>The entries that contain a word; all entries for null.</summary>
    public HistorySnapshot Filter(string? word) => word is null ? this : this with { Entries = [.. Entries.Where(entry => entry.Matches(word))] };
}
