namespace Engraver.Simulator.Language;

/// <summary>The downloaded program (galil-dmc.md A.6, 0.3).</summary>
internal sealed class ProgramMemory(int capacity)
{
    public const int LongestLine = 80;
    public const int MaximumLabels = 254;

    private readonly List<ProgramLine> lines = [];
    private readonly Dictionary<string, int> labels = new(StringComparer.Ordinal);

    public int Count => lines.Count;

    public int LabelsLeft => MaximumLabels - labels.Count;

    public ProgramLine this[int line] => lines[line];

    public IEnumerable<KeyValuePair<string, int>> Labels => labels.OrderBy(l => l.Key, StringComparer.Ordinal);

    public bool TryFind(string label, out int line) => labels.TryGetValue(label, out line);

    /// <summary>Keeps the first <paramref name="count"/> lines.</summary>
    public void Truncate(int count)
    {
        lines.RemoveRange(count, lines.Count - count);
        foreach (string label in labels.Where(l => l.Value >= count).Select(l => l.Key).ToArray())
        {
            labels.Remove(label);
        }
    }

    /// <summary>Appends a line or refuses it with TC 60 to 62. Empty lines are dropped (A.6).</summary>
    public void Append(string text)
    {
        if (text.Trim().Length == 0)
        {
            return;
        }

        if (text.Length > LongestLine || lines.Count >= capacity)
        {
            throw new CommandRefusedException(Tc.DownloadError);
        }

        var line = ProgramLine.Parse(text);
        if (line.Label is { } label)
        {
            AddLabel(label);
        }

        lines.Add(line);
    }

    private void AddLabel(string label)
    {
        if (labels.Count >= MaximumLabels)
        {
            throw new CommandRefusedException(Tc.TooManyLabels);
        }

        if (!labels.TryAdd(label, lines.Count))
        {
            throw new CommandRefusedException(Tc.BadLabel);
        }
    }
}
