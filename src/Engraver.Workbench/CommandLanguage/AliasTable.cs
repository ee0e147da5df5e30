namespace Engraver.Workbench.CommandLanguage;

/// <summary>Short names of commands in the format of AutoCAD's PGP file: <c>ABBR, *COMMAND</c>, one on a line, <c>;</c> begins a comment. Later lines win,
/// so a user's file can override.</summary>
public sealed class AliasTable
{
    private readonly Dictionary<string, string> _commands;

    private AliasTable(Dictionary<string, string> commands, IReadOnlyList<string> findings) => (_commands, Findings) = (commands, findings);

    public static AliasTable Empty { get; } = new(new Dictionary<string, string>(StringComparer.OrdinalIgnoreCase), []);

    /// <summary>One sentence for each invalid line. A line for an unknown command is ignored, so that a file made for AutoCAD can be used.</summary>
    public IReadOnlyList<string> Findings { get; }

    /// <summary>Alias and command, both in capitals.</summary>
    public IReadOnlyDictionary<string, string> Commands => _commands;

    /// <summary>This table overridden by the lines of a file.</summary>
    /// <param name="isAllowed">Says whether an alias may stand for a command; false refuses the line with a finding.</param>
    public AliasTable With(string text, Func<string, string, bool> isAllowed)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(isAllowed);
        var commands = new Dictionary<string, string>(_commands, StringComparer.OrdinalIgnoreCase);
        var findings = new List<string>();
        var number = 0;
        foreach (var line in text.ReplaceLineEndings("\n").Split('\n'))
        {
            number++;
            var content = line.Split(';', 2)[0].Trim();
            if (content.Length == 0) continue;
            if (Read(content) is not { } entry) continue;
            if (isAllowed(entry.Alias, entry.Command)) commands[entry.Alias] = entry.Command;
            else findings.Add(Wording.Get("AliasTable.AliasTooShort", number, entry.Alias, entry.Command));
        }

        return new AliasTable(commands, findings);
    }

    public string? CommandOf(string alias) => _commands.GetValueOrDefault(alias);

    /// <summary>External commands of a PGP file (<c>DIR,DIR,8,...</c>) have no star and are ignored.</summary>
    private static (string Alias, string Command)? Read(string line)
    {
        var fields = line.Split(',', StringSplitOptions.TrimEntries);
        return fields.Length == 2 && fields[0].Length > 0 && fields[1].Length > 1 && fields[1][0] == '*'
            ? (fields[0].ToUpperInvariant(), fields[1][1..].ToUpperInvariant())
            : null;
    }
}
