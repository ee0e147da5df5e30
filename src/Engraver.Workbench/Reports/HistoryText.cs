using System.Globalization;
using Engraver.Workbench.Histories;

namespace Engraver.Workbench.Reports;

/// <summary>Text report of the history of jobs.</summary>
public static class HistoryText
{
    /// <summary>A line for each entry; times in the local time zone.</summary>
    /// <param name="entries">Entries with the numbers used to select them.</param>
    public static void Write(TextWriter output, IEnumerable<(int Number, HistoryEntry Entry)> entries, TimeZoneInfo here)
    {
        ArgumentNullException.ThrowIfNull(output);
        ArgumentNullException.ThrowIfNull(entries);
        foreach (var (number, entry) in entries)
        {
            var what = entry.Mode is { } mode ? $"{entry.Kind} {mode} {entry.Address}" : $"{entry.Kind} {Target(entry)}";
            output.WriteLine(string.Join("  ", new[] { $"{number,4}", Date(entry, here), Path.GetFileName(entry.Drawing), what, entry.Outcome, Figures(entry), ReadBack(entry), entry.Plate ?? "" }.Where(part => part.Length > 0)));
        }
    }

    /// <summary>The post with its options.</summary>
    public static string Target(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        return string.Join(' ', entry.Options.OrderBy(option => option.Key, StringComparer.Ordinal).Select(option => $"{option.Key}={option.Value}").Prepend(entry.Target));
    }

    /// <summary>The read-back state of its program; empty if it was not read back.</summary>
    public static string ReadBack(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        return entry.ReadBack is { } found ? Wording.Get("ReadBackState." + HistoryEntry.ReadBackWord(found)) : "";
    }

    /// <summary>Start time in the local time zone.</summary>
    public static string Date(HistoryEntry entry, TimeZoneInfo here)
    {
        ArgumentNullException.ThrowIfNull(entry);
        return Wording.Get("History.Moment", TimeZoneInfo.ConvertTime(entry.Date, here));
    }

    /// <summary>Names the axes whose deviation is based on commanded positions; empty if it is based on motor positions.</summary>
    public static string OpenLoop(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        return entry.OpenLoop is { Count: > 0 } axes ? Wording.Get("History.CommandedOnly", string.Join(", ", axes)) : "";
    }

    private static string Figures(HistoryEntry entry) => string.Create(CultureInfo.InvariantCulture, $"{(entry.Seconds is { } seconds ? $"{seconds:0.0} s" : "")}{(entry.MaxDeviation is { } deviation ? $"  {deviation:0.0000} mm {OpenLoop(entry)}" : "")}").Trim();
}
