namespace Engraver.Fonts.Finding;

/// <summary>Reads lines <c>wanted;substitute</c>. Empty lines, and lines that start with # or ;, are comments.</summary>
internal sealed class SubstituteTable
{
    private readonly Dictionary<string, List<string>> _lines = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<SubstituteFault> _faults = [];

    public IReadOnlyDictionary<string, IReadOnlyList<string>> Lines => _lines.ToDictionary(line => line.Key, line => (IReadOnlyList<string>)line.Value, StringComparer.OrdinalIgnoreCase);

    public IReadOnlyList<SubstituteFault> Faults => _faults;

    /// <summary>A name without its folder and without the extension .shx, which styles may leave out.</summary>
    public static string KeyOf(string name)
    {
        var file = FontFileName.Of(name);
        return file.EndsWith(".shx", StringComparison.OrdinalIgnoreCase) ? file[..^4] : file;
    }

    public void Read(string path, TextReader text)
    {
        for (var number = 1; text.ReadLine() is { } line; number++)
        {
            var trimmed = line.Trim();
            if (trimmed.Length == 0 || trimmed[0] is '#' or ';') continue;
            if (trimmed.Split(';', StringSplitOptions.TrimEntries) is not [{ Length: > 0 } wanted, { Length: > 0 } substitute])
            {
                _faults.Add(new SubstituteFault(path, number, trimmed));
                continue;
            }

            var key = KeyOf(wanted);
            if (!_lines.TryGetValue(key, out var substitutes)) _lines.Add(key, substitutes = []);
            substitutes.Add(substitute);
        }
    }

    public void Refuse(string path) => _faults.Add(new SubstituteFault(path, 0, ""));
}
