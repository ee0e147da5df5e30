using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>The downloaded program (galil-dmc.md A.6, 0.3).</summary>
internal sealed class ProgramMemory(int capacity)
{
    public const int LongestLine = MemorySizes.LongestLine;
    public const int MaximumLabels = 254;

    private readonly List<ProgramLine> _lines = [];
    private readonly Dictionary<string, int> _labels = new(StringComparer.Ordinal);

    public int Count => _lines.Count;

    public int LabelsLeft => MaximumLabels - _labels.Count;

    public ProgramLine this[int line] => _lines[line];

    public IEnumerable<KeyValuePair<string, int>> Labels => _labels.OrderBy(l => l.Key, StringComparer.Ordinal);

    public bool TryFind(string label, out int line) => _labels.TryGetValue(label, out line);

    /// <summary>Keeps the first <paramref name="count"/> lines.</summary>
    public void Truncate(int count)
    {
        _lines.RemoveRange(count, _lines.Count - count);
        foreach (var label in _labels.Where(l => l.Value >= count).Select(l => l.Key).ToArray())
        {
            _labels.Remove(label);
        }
    }

    /// <summary>Appends a line or refuses it with TC 60 to 62. Empty lines are dropped (A.6).</summary>
    public void Append(string text)
    {
        if (text.Trim().Length == 0) return;

        if (text.Length > LongestLine || _lines.Count >= capacity) throw new CommandRefusedException(Tc.DownloadError);

        var line = ProgramLine.Parse(text);
        if (line.Label is { } label) AddLabel(label);

        _lines.Add(line);
    }

    private void AddLabel(string label)
    {
        if (_labels.Count >= MaximumLabels) throw new CommandRefusedException(Tc.TooManyLabels);

        if (!_labels.TryAdd(label, _lines.Count)) throw new CommandRefusedException(Tc.BadLabel);
    }
}
