namespace Engraver.Core.Machines.Moves;

/// <summary>What the inputs or the outputs of a controller are wired to, by number from 1. Compared by value: two with the same names are equal.</summary>
public sealed class IoLineNames : IEquatable<IoLineNames>
{
    private readonly SortedDictionary<int, string> _names;

    public IoLineNames(IEnumerable<KeyValuePair<int, string>> names) => _names = new SortedDictionary<int, string>(new Dictionary<int, string>(names));

    /// <summary>No line has a name.</summary>
    public static IoLineNames None { get; } = new([]);

    /// <summary>The lines that have a name, by number.</summary>
    public IReadOnlyDictionary<int, string> All => _names;

    /// <summary>The name, or the number where the line has no name.</summary>
    public string this[int line] => _names.GetValueOrDefault(line, line.ToString(System.Globalization.CultureInfo.InvariantCulture));

    /// <summary>The line with this name, ignoring case, or with this number; null when there is none.</summary>
    /// <param name="most">The largest number.</param>
    public int? Find(string text, int most)
    {
        foreach (var (line, name) in _names)
        {
            if (name.Equals(text, StringComparison.OrdinalIgnoreCase)) return line;
        }

        return int.TryParse(text, System.Globalization.NumberStyles.None, System.Globalization.CultureInfo.InvariantCulture, out var number) && number >= 1 && number <= most ? number : null;
    }

    public bool Equals(IoLineNames? other) => other is not null && _names.SequenceEqual(other._names);

    public override bool Equals(object? obj) => Equals(obj as IoLineNames);

    public override int GetHashCode() => _names.Aggregate(0, (hash, entry) => HashCode.Combine(hash, entry.Key, entry.Value));
}
