using System.Globalization;
using Engraver.Workbench.Histories;

namespace Engraver.Workbench.Reports;

/// <summary>The history of jobs for people.</summary>
public static class HistoryText
{
    /// <summary>A line for each entry; times of day as they are here.</summary>
    /// <param name="entries">Each with the number by which the operator may name it.</param>
    public static void Write(TextWriter output, IEnumerable<(int Number, HistoryEntry Entry)> entries, TimeZoneInfo here)
    {
        ArgumentNullException.ThrowIfNull(output);
        ArgumentNullException.ThrowIfNull(entries);
        foreach (var (number, entry) in entries)
        {
            var what = entry.Mode is { } mode ? $"{entry.Kind} {mode} {entry.Address}" : $"{entry.Kind} {Target(entry)}";
            output.WriteLine(string.Join("  ", new[] { $"{number,4}", Date(entry, here), Path.GetFileName(entry.Drawing), what, entry.Outcome, Figures(entry), ReadBack(entry) }.Where(part => part.Length > 0)));
        }
    }

    /// <summary>The post with what was chosen for it.</summary>
    public static string Target(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        return string.Join(' ', entry.Options.OrderBy(option => option.Key, StringComparer.Ordinal).Select(option => $"{option.Key}={option.Value}").Prepend(entry.Target));
    }

    /// <summary>How its program was read back; empty where nobody did.</summary>
    public static string ReadBack(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        return entry.ReadBack is { } found ? Wording.Get("ReadBackState." + HistoryEntry.ReadBackWord(found)) : "";
    }

    /// <summary>When it began, by the clock here.</summary>
    public static string Date(HistoryEntry entry, TimeZoneInfo here)
    {
        ArgumentNullException.ThrowIfNull(entry);
        return Wording.Get("History.Moment", TimeZoneInfo.ConvertTime(entry.Date, here));
    }

    /// <summary>That the deviation is the commanded one, and of which axes; empty where it is that of the motors.</summary>
    public static string OpenLoop(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        return entry.OpenLoop is { Count: > 0 } axes ? Wording.Get("History.CommandedOnly", string.Join(", ", axes)) : "";
    }

    private static string Figures(HistoryEntry entry) => string.Create(CultureInfo.InvariantCulture, $"{(entry.Seconds is { } seconds ? $"{seconds:0.0} s" : "")}{(entry.MaxDeviation is { } deviation ? $"  {deviation:0.0000} mm {OpenLoop(entry)}" : "")}").Trim();
}
